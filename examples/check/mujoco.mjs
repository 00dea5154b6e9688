// A free body in MuJoCo's build for JavaScript. The variant is the integrator: Euler, implicit,
// implicitfast or RK4.
import { readFile } from "node:fs/promises";
import initMujoco from "@mujoco/mujoco";
import { problem, rejectVariant, simulate } from "./free_rotation.mjs";

const mujoco = await initMujoco();
const integrator = mujoco.mjtIntegrator[`mjINT_${problem.variant.toUpperCase()}`];
if (integrator === undefined) rejectVariant();
const xml = await readFile(new URL("free_body.xml", import.meta.url), "utf8");
const model = mujoco.MjModel.from_xml_string(xml);
model.opt.timestep = problem.step;
model.opt.integrator = integrator.value;
model.body_inertia.set(problem.moments, 3);
const data = new mujoco.MjData(model);
mujoco.mj_setConst(model, data); // values that MuJoCo derives from the moments
// qpos is the position and the quaternion of the free joint; qvel is its velocity in space axes and
// its angular velocity in body axes.
data.qvel.set(problem.omega, 3);
simulate(
  () => mujoco.mj_step(model, data),
  () => ({ q: [...data.qpos.slice(3, 7)], omega: [...data.qvel.slice(3, 6)] }),
);
