// The exact motion of a scene at given times, by `twrench simulate`, and angles for comparison.
import { execFileSync } from "node:child_process";
import process from "node:process";
import { Matrix4, Quaternion, Vector3 } from "three";

/// The same pseudo-random numbers, 0 to 1, in each run (mulberry32).
export function* random(seed) {
  for (;;) {
    seed = (seed + 0x6d2b79f5) | 0;
    let t = Math.imul(seed ^ (seed >>> 15), 1 | seed);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    yield ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  }
}

/// The attitude and omega in space at each time.
export function exactMotion(options, times) {
  const rows = [];
  for (let i = 0; i < times.length; i += 500) {
    const command = ["simulate", ...options, "--method", "exact", "--format", "json", "--times"];
    const text = execFileSync(process.env.TWRENCH, [...command, times.slice(i, i + 500).join(",")]);
    rows.push(...JSON.parse(text).samples);
  }
  return rows.map(({ X, omega }) => {
    const matrix = new Matrix4().set(
      X[0], X[1], X[2], 0, X[3], X[4], X[5], 0, X[6], X[7], X[8], 0, 0, 0, 0, 1);
    return {
      attitude: new Quaternion().setFromRotationMatrix(matrix),
      omega: new Vector3(...omega).applyMatrix4(matrix),
    };
  });
}

/// The angle between two attitudes, computed without a cosine so that small angles are accurate.
export function angleBetween(a, b) {
  const d = a.clone().normalize().conjugate().multiply(b.clone().normalize());
  return 2 * Math.atan2(Math.hypot(d.x, d.y, d.z), Math.abs(d.w));
}

export function angleBetweenVectors(a, b) {
  return Math.atan2(a.clone().cross(b).length(), a.dot(b));
}
