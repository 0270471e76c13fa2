// The parts of the synthetic course, with every shape and role.

export const parts = [];
function part(name, position, size, more = {}) {
  parts.push({
    name,
    position,
    size,
    shape: 'block',
    role: 'plain',
    rotation: [0, 0, 0, 1],
    color: [163, 162, 165],
    alpha: 255,
    material: '',
    ...more,
  });
  return parts.length - 1;
}

part('Spawn', [0, 0, 0], [10, 1, 10], { role: 'start', color: [90, 200, 120] });
part('Step 1', [0, 1, -11], [5, 1, 5], { color: [196, 120, 60], material: 'WoodPlanks' });
part('Step 2', [0, 2, -19], [5, 1, 5], { color: [60, 120, 196] });
export const lava = part('Lava', [0, -1, -26], [14, 1, 30], { role: 'kill', color: [255, 40, 20], material: 'Neon' });
export const lift = part('Lift', [0, 3, -27], [5, 1, 5], { role: 'moving' });
part('Ramp', [0, 3, -36], [6, 3, 8], { shape: 'wedge', rotation: [0, 1, 0, 0] });
part('Landing', [0, 4, -44], [8, 1, 8], { color: [120, 170, 90], material: 'Grass' });
part('Belt', [12, 4, -44], [16, 1, 5], { role: 'conveyor' });
part('Corner', [23, 4, -44], [5, 3, 5], { shape: 'cornerWedge' });
part('Tower', [26, 8, -44], [2, 10, 2], { shape: 'truss' });
part('Drum', [26, 3, -52], [3, 6, 6], { shape: 'cylinder', rotation: [0, 0, 0.7071, 0.7071] });
export const bar = part('Spinner', [26, 7, -62], [14, 1, 1], { role: 'kill' });
part('Disc', [26, 5, -62], [1, 16, 16], { shape: 'cylinder', rotation: [0, 0, 0.7071, 0.7071] });
part('Pad', [26, 5, -75], [5, 1, 5], { role: 'pad' });
export const glass = part('Glass </script><b>', [26, 12, -84], [5, 1, 5], {
  role: 'vanish',
  alpha: 140,
  color: [200, 230, 255],
});
part('Boulder', [19, 8, -84], [5, 5, 5], { shape: 'ball', role: 'dynamic' });
part('Crystal', [33, 13, -84], [4, 6, 4], { shape: 'hull' });
part('Checkpoint', [26, 12, -92], [6, 1, 6], { role: 'checkpoint' });
part('Goal', [26, 14, -102], [8, 1, 8], { role: 'goal' });
part('Mist', [26, 18, -92], [6, 6, 1], { role: 'ghost', alpha: 60 });
for (let i = 0; i < 14; i++)
  part(`Pillar ${i}`, [-14 - (i % 3) * 5, -3 + (i % 4), -8 * i], [3, 14 + 3 * (i % 5), 3], {
    color: [110, 116, 130],
    material: 'Brick',
  });
