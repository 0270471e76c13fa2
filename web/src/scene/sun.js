// The light of the picture, and the sun's shadows over the query's box.
import { DirectionalLight, HemisphereLight, Vector3 } from 'three';

/** @import {Box3, Scene} from 'three' */

const kTowards = new Vector3(0.42, 1, 0.28);

export class Sun {
  /** @param {Scene} scene */
  constructor(scene) {
    this.sun = new DirectionalLight('#fff4e0', 2.2);
    this.sun.castShadow = true;
    this.sun.shadow.mapSize.set(2048, 2048);
    this.sun.shadow.bias = -0.0006;
    this.sun.shadow.normalBias = 0.06;
    const rim = new DirectionalLight('#8fb0ff', 0.7);
    rim.position.set(-0.6, 0.35, -0.7);
    scene.add(new HemisphereLight('#dfe8ff', '#2a2c36', 1.15), this.sun, this.sun.target, rim);
  }

  /**
   * The shadow map covers the query's box instead of the whole level, so that it stays sharp.
   * @param {Box3} course
   */
  cover(course) {
    const centre = course.getCenter(new Vector3());
    const reach = Math.max(20, (course.getSize(new Vector3()).length() / 2) * 1.25);
    this.sun.target.position.copy(centre);
    this.sun.position.copy(centre).addScaledVector(kTowards, reach * 2);
    const eye = this.sun.shadow.camera;
    [eye.left, eye.right, eye.bottom, eye.top] = [-reach, reach, -reach, reach];
    [eye.near, eye.far] = [0.1, reach * 5];
    eye.updateProjectionMatrix();
  }
}
