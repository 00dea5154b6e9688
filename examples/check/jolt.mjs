// A free body in Jolt. The variant is none, which is Jolt's default, or gyroscopic.
import initJolt from "jolt-physics";
import { problem, rejectVariant, simulate, toBody } from "./free_rotation.mjs";

if (!["none", "gyroscopic"].includes(problem.variant)) rejectVariant();
const Jolt = await initJolt();

// One layer of objects that collide with nothing.
const settings = new Jolt.JoltSettings();
const pairs = new Jolt.ObjectLayerPairFilterTable(1);
const layers = new Jolt.BroadPhaseLayerInterfaceTable(1, 1);
layers.MapObjectToBroadPhaseLayer(0, new Jolt.BroadPhaseLayer(0));
settings.mObjectLayerPairFilter = pairs;
settings.mBroadPhaseLayerInterface = layers;
settings.mObjectVsBroadPhaseLayerFilter =
  new Jolt.ObjectVsBroadPhaseLayerFilterTable(layers, 1, pairs, 1);
const jolt = new Jolt.JoltInterface(settings);
const system = jolt.GetPhysicsSystem();
system.SetGravity(new Jolt.Vec3(0, 0, 0));

const creation = new Jolt.BodyCreationSettings(
  new Jolt.SphereShape(1), new Jolt.RVec3(0, 0, 0), new Jolt.Quat(0, 0, 0, 1),
  Jolt.EMotionType_Dynamic, 0);
creation.mOverrideMassProperties = Jolt.EOverrideMassProperties_MassAndInertiaProvided;
creation.mMassPropertiesOverride.mMass = 1;
creation.mMassPropertiesOverride.mInertia = Jolt.Mat44.prototype.sScaleVec3(new Jolt.Vec3(...problem.moments));
creation.mAngularDamping = 0;
creation.mAllowSleeping = false;
creation.mApplyGyroscopicForce = problem.variant === "gyroscopic";
creation.mAngularVelocity = new Jolt.Vec3(...problem.omega);
const bodies = system.GetBodyInterface();
const body = bodies.CreateBody(creation);
bodies.AddBody(body.GetID(), Jolt.EActivation_Activate);

simulate(
  () => jolt.Step(problem.step, 1),
  () => {
    const turned = body.GetRotation(), rates = body.GetAngularVelocity();
    const q = [turned.GetW(), turned.GetX(), turned.GetY(), turned.GetZ()];
    return { q, omega: toBody(q, [rates.GetX(), rates.GetY(), rates.GetZ()]) };
  },
);
