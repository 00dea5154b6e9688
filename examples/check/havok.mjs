// A free body in Havok.
import { readFile } from "node:fs/promises";
import { fileURLToPath } from "node:url";
import initHavok from "@babylonjs/havok";
import { problem, simulate, toBody } from "./free_rotation.mjs";

const wasm = import.meta.resolve("@babylonjs/havok/lib/esm/HavokPhysics.wasm");
const havok = await initHavok({ wasmBinary: await readFile(fileURLToPath(wasm)) });

const [, world] = havok.HP_World_Create();
havok.HP_World_SetGravity(world, [0, 0, 0]);
havok.HP_World_SetIdealStepTime(world, problem.step);
const [, body] = havok.HP_Body_Create();
havok.HP_Body_SetMotionType(body, havok.MotionType.DYNAMIC);
havok.HP_Body_SetMassProperties(body, [[0, 0, 0], 1, problem.moments, [0, 0, 0, 1]]);
havok.HP_Body_SetAngularDamping(body, 0);
havok.HP_Body_SetActivationControl(body, havok.ActivationControl.ALWAYS_ACTIVE);
havok.HP_Body_SetAngularVelocity(body, problem.omega);
havok.HP_World_AddBody(world, body, false);
simulate(
  () => havok.HP_World_Step(world, problem.step),
  () => {
    const [, [x, y, z, w]] = havok.HP_Body_GetOrientation(body);
    const [, rates] = havok.HP_Body_GetAngularVelocity(body);
    const q = [w, x, y, z];
    return { q, omega: toBody(q, rates) };
  },
);
