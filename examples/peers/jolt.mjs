#!/usr/bin/env node
// SPDX-License-Identifier: MIT
// Jolt, through WebAssembly, as an engine of `frostfill-lab peers`. Do this once in its folder:
//     npm install jolt-physics@1.1.0
// Then, with the path of this file: `frostfill-lab peers --peer Jolt=examples/peers/jolt.mjs`.
// Lengths are in radii of the spheres, times in sqrt(r/g); down is -y.
import { readSync, writeSync } from "node:fs";

function fail(error) {
  console.error(String(error.message ?? error).split("\n")[0]);
  process.exit(1);
}
process.on("uncaughtException", fail);

const { default: initJolt } = await import("jolt-physics").catch(fail);
const Jolt = await initJolt({ print: console.error });
const kWalls = 0;
const kSpheres = 1;

/// Lines of standard input, one after the other; at the end `end`.
function* linesOfInput() {
  const chunk = Buffer.alloc(1 << 16);
  let rest = "";
  for (let size; (size = readSync(0, chunk)) > 0; ) {
    const lines = (rest + chunk.toString("latin1", 0, size)).split("\n");
    rest = lines.pop();
    yield* lines;
  }
}

const input = linesOfInput();
const nextWords = () => (input.next().value ?? "end").split(" ");
const rows = (count) => Array.from({ length: Number(count) }, () => nextWords().map(Number));

function answer(text) {
  for (let bytes = Buffer.from(text); bytes.length > 0; bytes = bytes.subarray(writeSync(1, bytes)));
}

/// What stands before `start`, by its word.
function readHeader() {
  const header = {};
  for (let words = nextWords(); words[0] !== "start"; words = nextWords()) {
    const [word, value] = words;
    if (word === "end") process.exit(1);
    header[word] = word === "vertices" || word === "triangles" ? rows(value) : Number(value);
  }
  return header;
}

function makeJolt(spheres) {
  const settings = new Jolt.JoltSettings();
  settings.mMaxWorkerThreads = 0;
  settings.mMaxBodies = spheres + 1;
  settings.mMaxBodyPairs = 12 * spheres + 1024; // whose boxes touch: fourteen a sphere, shared by two
  settings.mMaxContactConstraints = 6 * spheres + 1024; // a sphere has twelve neighbours at most
  const pairs = new Jolt.ObjectLayerPairFilterTable(2);
  pairs.EnableCollision(kWalls, kSpheres);
  pairs.EnableCollision(kSpheres, kSpheres);
  const layers = new Jolt.BroadPhaseLayerInterfaceTable(2, 2);
  layers.MapObjectToBroadPhaseLayer(kWalls, new Jolt.BroadPhaseLayer(kWalls));
  layers.MapObjectToBroadPhaseLayer(kSpheres, new Jolt.BroadPhaseLayer(kSpheres));
  settings.mObjectLayerPairFilter = pairs;
  settings.mBroadPhaseLayerInterface = layers;
  settings.mObjectVsBroadPhaseLayerFilter = new Jolt.ObjectVsBroadPhaseLayerFilterTable(layers, 2, pairs, 2);
  const jolt = new Jolt.JoltInterface(settings);
  giveRoom(Jolt.getPointer(jolt.GetTempAllocator()) >> 2, 512 * settings.mMaxContactConstraints + (8 << 20));
  return jolt;
}

/// In WebAssembly a step has 10 MB of scratch memory, which is enough for 20,000 contacts, and there is no
/// setting for it. The allocator's words are: virtual table, start, size, used.
function giveRoom(allocator, bytes) {
  if (Jolt.HEAPU32[allocator + 2] !== 10 << 20 || Jolt.HEAPU32[allocator + 3] !== 0) {
    throw new Error("this version of jolt-physics keeps its scratch memory in another way");
  }
  if (bytes <= 10 << 20) return;
  Jolt.HEAPU32[allocator + 1] = (Jolt._webidl_malloc(bytes + 16) + 15) & ~15;
  Jolt.HEAPU32[allocator + 2] = bytes;
}

/// Jolt's tolerances are for bodies of a metre and a gravity of 9.81; here a radius is 1 and gravity 1.
function setTolerances(system, header) {
  const settings = system.GetPhysicsSettings();
  settings.mPenetrationSlop = 0.001; // [r] overlap that is left: Jolt's 0.02 would be all that one sees
  settings.mSpeculativeContactDistance = 0.02; // [r] as it comes
  settings.mMinVelocityForRestitution = header.bounce; // [sqrt(g r)]
  settings.mPointVelocitySleepThreshold = header.still; // [sqrt(g r)]
  settings.mTimeBeforeSleep = 2; // [sqrt(r/g)] as long as Bullet takes
  system.SetPhysicsSettings(settings);
  system.SetGravity(new Jolt.Vec3(0, -1, 0));
}

function addBody(bodies, shape, [x, y, z], motion, layer, header) {
  const settings = new Jolt.BodyCreationSettings(
    shape, new Jolt.RVec3(x, y, z), new Jolt.Quat(0, 0, 0, 1), motion, layer);
  settings.mRestitution = header.restitution; // of two bodies Jolt takes the larger one
  settings.mFriction = header.friction; // and of frictions the root of the product
  settings.mLinearDamping = 0;
  settings.mAngularDamping = 0;
  if (layer === kSpheres) {
    settings.mOverrideMassProperties = Jolt.EOverrideMassProperties_CalculateInertia;
    settings.mMassPropertiesOverride.mMass = 1;
    settings.mMotionQuality = Jolt.EMotionQuality_LinearCast; // so that none passes through a wall
  }
  const body = bodies.CreateBody(settings);
  bodies.AddBody(body.GetID(), layer === kSpheres ? Jolt.EActivation_Activate : Jolt.EActivation_DontActivate);
  Jolt.destroy(settings);
  return body;
}

/// Jolt's triangles act on their front side alone: each is there twice, once from either side.
function meshShape({ vertices, triangles }) {
  const points = new Jolt.VertexList();
  const faces = new Jolt.IndexedTriangleList();
  for (const [x, y, z] of vertices) points.push_back(new Jolt.Float3(x, y, z));
  for (const [a, b, c] of triangles) {
    faces.push_back(new Jolt.IndexedTriangle(a, b, c, 0));
    faces.push_back(new Jolt.IndexedTriangle(a, c, b, 0));
  }
  return new Jolt.MeshShapeSettings(points, faces, new Jolt.PhysicsMaterialList()).Create().Get();
}

const header = readHeader();
const jolt = makeJolt(header.spheres);
setTolerances(jolt.GetPhysicsSystem(), header);
const bodies = jolt.GetPhysicsSystem().GetBodyInterface();
addBody(bodies, meshShape(header), [0, 0, 0], Jolt.EMotionType_Static, kWalls, header);
const sphere = new Jolt.SphereShape(1);
sphere.AddRef();
const spheres = [];
answer("ready\n");
for (let words = nextWords(); words[0] !== "end"; words = nextWords()) {
  const [word, ...numbers] = words;
  if (word === "step") {
    jolt.Step(header.step, 1);
  } else if (word === "add") {
    spheres.push(addBody(bodies, sphere, numbers.map(Number), Jolt.EMotionType_Dynamic, kSpheres, header));
  } else if (word === "places") {
    const places = spheres.map((body) => {
      const p = body.GetPosition();
      return `${p.GetX()} ${p.GetY()} ${p.GetZ()}\n`;
    });
    answer(`places ${spheres.length}\n${places.join("")}`);
  }
}
process.exit(0);
