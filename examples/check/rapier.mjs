// A free body in Rapier.
import rapier from "@dimforge/rapier3d-compat";
import { problem, simulate, toBody } from "./free_rotation.mjs";

const vector = ([x, y, z]) => ({ x, y, z });

await rapier.init();
const zero = { x: 0, y: 0, z: 0 }, identity = { x: 0, y: 0, z: 0, w: 1 };
const world = new rapier.World(zero);
world.timestep = problem.step;
const body = world.createRigidBody(
  rapier.RigidBodyDesc.dynamic()
    .setAdditionalMassProperties(1, zero, vector(problem.moments), identity)
    .setAngvel(vector(problem.omega))
    .setCanSleep(false),
);
simulate(
  () => world.step(),
  () => {
    const { x, y, z, w } = body.rotation(), rates = body.angvel();
    const q = [w, x, y, z];
    return { q, omega: toBody(q, [rates.x, rates.y, rates.z]) };
  },
);
