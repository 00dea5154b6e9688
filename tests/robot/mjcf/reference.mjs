// node reference.mjs FOLDER: prints the mass properties of the bodies of each MJCF file of the folder,
// as MuJoCo compiles them, as JSON. scripts/maintain/mujoco.sh runs it.
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import load from '@mujoco/mujoco';

const folder = process.argv[2];
const mujoco = await load();
const filesIn = (part) =>
  readdirSync(join(folder, part), { withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => join(part, entry.name))
    .sort();

for (const part of ['meshes', 'parts']) mujoco.FS.mkdir(`/${part}`);
for (const file of [...filesIn('.'), ...filesIn('meshes'), ...filesIn('parts')])
  mujoco.FS.writeFile(`/${file}`, readFileSync(join(folder, file)));

const bodyType = 1; // mjOBJ_BODY
const bodiesOf = (model) => {
  const lines = [];
  for (let i = 1; i < model.nbody; ++i) {
    const row = (values, width) => [...values.slice(i * width, (i + 1) * width)];
    const body = {
      mass: model.body_mass[i],
      ipos: row(model.body_ipos, 3),
      iquat: row(model.body_iquat, 4),
      inertia: row(model.body_inertia, 3),
    };
    // JSON.stringify writes the fewest digits that give the same double.
    lines.push(`   "${mujoco.mj_id2name(model, bodyType, i)}": ${JSON.stringify(body)}`);
  }
  return lines.join(',\n');
};

const files = filesIn('.')
  .filter((name) => name.endsWith('.xml'))
  .map((name) => `  "${name}": {\n${bodiesOf(mujoco.MjModel.from_xml_path(`/${name}`))}\n  }`);
console.log(`{\n "mujoco": "${mujoco.mj_versionString()}",\n "files": {\n${files.join(',\n')}\n }\n}`);
