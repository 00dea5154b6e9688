// Plays .glb files in three.js at 1000 random times and compares them with the exact motion.
// Usage: node three_test.mjs FILE.glb BOUND SPEED DURATION [option of simulate ...]
import { readFile } from "node:fs/promises";
import process from "node:process";
import { AnimationMixer, Quaternion, Vector3 } from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
import { angleBetween, angleBetweenVectors, exactMotion, random } from "./motion.mjs";

const [file, bound, speed, duration, ...options] = process.argv.slice(2);
const bytes = await readFile(file);
const gltf = await new GLTFLoader().parseAsync(new Uint8Array(bytes).buffer, "");
const mixer = new AnimationMixer(gltf.scene);
mixer.clipAction(gltf.animations[0]).play();

const dice = random(2026);
const times = Array.from({ length: 1000 }, () => (dice.next().value * Number(duration)) / Number(speed));
const exact = exactMotion(options, times.map((t) => t * Number(speed)));
const body = gltf.scene.getObjectByName("body"), arrow = gltf.scene.getObjectByName("omega");
const initial = arrow ? exactMotion(options, [0])[0].omega.length() : 0;
const worst = { attitude: 0, direction: 0, length: 0 };
times.forEach((time, i) => {
  mixer.setTime(time);
  gltf.scene.updateMatrixWorld(true);
  const { attitude, omega } = exact[i];
  worst.attitude = Math.max(worst.attitude, angleBetween(body.getWorldQuaternion(new Quaternion()), attitude));
  if (!arrow) return;
  const shown = new Vector3(0, 0, 1).applyQuaternion(arrow.getWorldQuaternion(new Quaternion()));
  worst.direction = Math.max(worst.direction, angleBetweenVectors(shown, omega));
  worst.length = Math.max(worst.length, Math.abs((arrow.scale.z * initial) / omega.length() - 1));
});
console.log(`${file}: off by at most ${Object.entries(worst).map(([what, by]) => `${by.toExponential(2)} (${what})`).join(", ")}; bound ${bound}`);
process.exit(Math.max(...Object.values(worst)) <= Number(bound) ? 0 : 1);
