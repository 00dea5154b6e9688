// Stars that show how a turning frame turns: src/picture/overlay/fixed_stars.cpp.
import { cross, norm, rotation, scale, times } from '../math/linear.js';
import { mersenneTwister } from '../math/mersenne_twister.js';
import { addDot, addLine } from './lines.js';

const starCount = 260;
const starDistance = 12; // of the camera's from the body
const starWidth = 3.4; // px of the brightest, in a picture of 1080
const brightestStar = 0.75; // opacity
const fadingStreak = 12; // widths, of which a streak is half as bright as a dot
const streakPoints = 5;
const defaultSeed = 5489; // of std::mt19937
const golden = (1 + Math.sqrt(5)) / 2;

/** Spread evenly, each on a turn of a spiral from pole to pole. */
function spiral() {
  const random = mersenneTwister(defaultSeed);
  return Array.from({ length: starCount }, (_, i) => {
    const height = 1 - (2 * (i + random())) / starCount;
    const angle = 2 * Math.PI * (i * golden + 0.1 * random());
    const across = Math.sqrt(Math.max(0, 1 - height * height));
    const direction = [across * Math.cos(angle), height, across * Math.sin(angle)];
    return { direction, brightness: 0.2 + 0.8 * random() ** 3 };
  });
}

const stars = spiral();

/**
 * @param {import('./draw_list.js').DrawList} list
 * @param {number[]} omega Of the frame in space, rad/s.
 * @param {number} halfOpen Half the time for which a shutter would be open, s; 0 for dots.
 * @param {number} cameraDistance cm
 * @param {{color: number[], height: number}} look Colour, and the height of the picture in pixels.
 */
export function addFixedStars(list, omega, halfOpen, cameraDistance, { color, height }) {
  const far = starDistance * cameraDistance;
  const turns = Array.from({ length: streakPoints }, (_, i) =>
    rotation(scale(-halfOpen * ((2 * i) / (streakPoints - 1) - 1), omega)),
  );
  for (const { direction, brightness } of stars) {
    const places = turns.map((turn) => scale(far, times(turn, direction)));
    const width = (starWidth * Math.sqrt(brightness) * height) / 1080;
    const length = 2 * halfOpen * norm(cross(omega, direction)) * list.pixels(places[0]) * far;
    const ink = { color, opacity: (brightestStar * brightness) / (1 + length / (fadingStreak * width)) };
    if (length > 1)
      addLine(
        list,
        places.map((place) => ({ place, width, ink })),
      );
    else addDot(list, places[0], width / 2, ink);
  }
}
