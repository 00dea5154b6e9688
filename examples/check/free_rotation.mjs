// Shared by the JavaScript programs in this folder: the command line, and the rows of CSV that
// `twrench check` reads.
import process from "node:process";

const numbers = (text) => (text ?? "").split(",").map(Number);
const [step, moments, omega, duration, variant = ""] = process.argv.slice(2);

// The command line: STEP A,B,C X,Y,Z DURATION [VARIANT].
export const problem = {
  step: Number(step), // s
  moments: numbers(moments), // principal moments about the body's x, y and z axes
  omega: numbers(omega), // angular velocity at t = 0, rad/s; body and space axes then coincide
  duration: Number(duration), // s
  variant, // the engine's integrator or option
};
if (!(problem.duration > 0) || !(problem.step > 0 && problem.step <= 0.1)) {
  console.error("usage: node PROGRAM STEP A,B,C X,Y,Z DURATION [VARIANT]; STEP divides 0.1");
  process.exit(2);
}

// Ends a program that does not know the variant.
export function rejectVariant() {
  console.error(`there is no variant '${variant}'`);
  process.exit(3);
}

// Turns a vector from space to body axes by the inverse of the quaternion w, x, y, z.
export function toBody([w, x, y, z], [a, b, c]) {
  const cross = [y * c - z * b, z * a - x * c, x * b - y * a];
  return [
    a + 2 * (-w * cross[0] + y * cross[2] - z * cross[1]),
    b + 2 * (-w * cross[1] + z * cross[0] - x * cross[2]),
    c + 2 * (-w * cross[2] + x * cross[1] - y * cross[0]),
  ];
}

// Writes the header, and a row at t = 0 and every 0.1 s. `advance` makes one step; `state` returns
// the attitude as a quaternion w, x, y, z from body to space axes, and the angular velocity in body
// axes, rad/s.
export function simulate(advance, state) {
  const lines = ["t,qw,qx,qy,qz,wx,wy,wz"];
  const stepsPerRow = Math.round(0.1 / problem.step);
  for (let row = 0; row <= Math.round(problem.duration / 0.1); ++row) {
    const { q, omega } = state();
    lines.push([row * stepsPerRow * problem.step, ...q, ...omega].join(","));
    for (let i = 0; i < stepsPerRow; ++i) advance();
  }
  process.stdout.write(`${lines.join("\n")}\n`);
}
