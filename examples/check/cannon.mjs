// A free body in cannon-es, which has no gyroscopic term.
import { Body, Vec3, World } from "cannon-es";
import { problem, simulate, toBody } from "./free_rotation.mjs";

const world = new World(); // without gravity
const body = new Body({ mass: 1, angularDamping: 0, angularVelocity: new Vec3(...problem.omega) });
body.inertia.set(...problem.moments);
body.invInertia.set(...problem.moments.map((moment) => 1 / moment));
world.addBody(body);
simulate(
  () => world.step(problem.step),
  () => {
    const { x, y, z, w } = body.quaternion;
    const q = [w, x, y, z];
    return { q, omega: toBody(q, body.angularVelocity.toArray()) };
  },
);
