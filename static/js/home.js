// The home of a household: which one it is, and what stands in its rooms.

import { post } from "./api.js";
import { byId, h } from "./dom.js";

const OWN = "";

export class Home {
  /** `chosen(name)` is called when somebody picks a home of the catalogue. */
  constructor(chosen) {
    this.select = byId("home");
    this.rooms = byId("rooms-part");
    this.select.addEventListener("change", () => chosen(this.select.value));
    this.rooms.addEventListener("toggle", () => this.tell());
  }

  /** Show the home of a scene, of those its world has ready; none has no home. */
  show(scene, names) {
    byId("home-field").hidden = this.rooms.hidden = !names.length;
    if (!names.length) return;
    this.scene = { world: scene.world, ...(scene.graph ? { graph: scene.graph } : { environment: scene.environment ?? names[0] }) };
    this.select.replaceChildren(
      ...(scene.graph ? [h("option", { value: OWN }, "of your own")] : []),
      ...names.map((name) => h("option", { value: name }, name)),
    );
    this.select.value = scene.graph ? OWN : this.scene.environment;
    this.tell();
  }

  /** Tell what is in its rooms, once somebody wants to know. */
  async tell() {
    const key = JSON.stringify(this.scene);
    if (!this.rooms.open || this.rooms.hidden || this.told === key) return;
    this.told = key;
    const list = byId("room-list");
    list.replaceChildren();
    try {
      const { objects } = (await post("/scenes/validate", this.scene)).scene;
      if (this.told === key) list.replaceChildren(...described(objects));
    } catch (error) {
      this.told = null;
      list.replaceChildren(h("p", { class: "hint" }, error.message));
    }
  }
}

function described(objects) {
  const rooms = objects.filter((thing) => thing.category === "room");
  return rooms.flatMap(({ name }) => {
    const there = objects.filter((thing) => (thing.properties.room ?? "").split(" ").includes(name));
    return [h("dt", {}, name), h("dd", {}, there.map((thing) => thing.name).join(", ") || "nothing")];
  });
}
