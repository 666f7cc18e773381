# SPDX-License-Identifier: Apache-2.0
"""What blender_test.py has Blender do: in_blender.py -- LUXEL CHECK FOLDER."""
import importlib.util
import json
import os
import subprocess
import sys
import tempfile
import time
import traceback

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
ADD_ON = os.path.join(ROOT, "integrations", "blender", "luxel_bake.py")
sys.path.insert(0, HERE)

import bpy  # noqa: E402
import numpy as np  # noqa: E402

import luminaires  # noqa: E402
import rooms  # noqa: E402
import truth  # noqa: E402


def add_on():
    """The add-on as it lies in the sources, switched on."""
    spec = importlib.util.spec_from_file_location("luxel_bake", ADD_ON)
    module = importlib.util.module_from_spec(spec)
    sys.modules["luxel_bake"] = module
    spec.loader.exec_module(module)
    module.register()
    return module


def expect(holds, words):
    if not holds:
        raise AssertionError(words)


def expect_near(found, wanted, share, words):
    found, wanted = np.asarray(found, float), np.asarray(wanted, float)
    expect(np.all(np.abs(found - wanted) <= share * np.abs(wanted)), f"{words}: found {found}, expected {wanted}")


def told(name, areas, ours, theirs):
    """Our light as a share of theirs, and the mean difference as a share of it, both by area and over all colours."""
    area = areas[:, None]
    light = (area * theirs).sum()
    whole, difference = (area * ours).sum() / light, (area * np.abs(ours - theirs)).sum() / light
    print(f"  {name}: {len(area)} quads have {whole:.4f} of Cycles' light, mean difference {100.0 * difference:.2f} %")
    return whole, difference


class Check:
    def __init__(self, luxel, folder):
        self.luxel, self.folder = luxel, folder
        self.scene = rooms.fresh_scene()
        self.add_on = add_on()

    def printed(self, *words):
        done = subprocess.run([self.luxel, *words], cwd=self.folder, capture_output=True, text=True, check=False)
        expect(done.returncode == 0, f"luxel {' '.join(words)}: {done.stderr}")
        return done.stdout

    def bake(self, **settings):
        for name, value in settings.items():
            setattr(bpy.context.scene.luxel, name, value)
        return bpy.ops.luxel.bake(program=self.luxel)

    # ---- file: Luxel reads what is written ----

    def file(self):
        scene = self.scene
        self.mixed_scene()
        exporter = self.add_on.Exporter(bpy.context)
        exporter.write(os.path.join(self.folder, "scene.glb"))
        info = json.loads(self.printed("info", "scene.glb", "--json"))
        materials = {item["name"]: item for item in info["materials"]}
        count = {name: item["triangles"] for name, item in materials.items()}
        expect(count["painted"] == 12 + 12, f"a cube and its instance in a collection: {count}")
        expect(count["plain"] == 4 * 6 * 2, f"a subdivided cube as the modifier makes it: {count}")
        expect(count["two tone"] == 2 and count["second"] == 2, f"a mesh of two materials: {count}")
        expect(count["shine"] == 4, f"a sheet that shines has a back of its own: {count}")
        expect(count["Area"] == 2 * 100, f"an area lamp in squares: {count}")
        expect("hidden" not in materials, f"what is not rendered: {count}")
        expect(not materials["glass"]["opaque"] and materials["plain"]["opaque"], "glass lets light pass")
        # The picture is a quarter of (1, 0, 0) and three of (0, 0.5, 0) in sRGB codes: 0.214 linear.
        expect_near(materials["painted"]["reflectance"], (0.25, 0.75 * 0.2140, 0.0), 0.01, "the mean of the picture")
        expect_near(materials["plain"]["reflectance"], (0.44, 0.54, 0.64), 1e-5, "Principled BSDF's colour and its gloss")
        plain = self.add_on.MaterialReader(gloss_is_diffuse=False).read(bpy.data.materials["plain"])
        expect_near(plain.colour, (0.4, 0.5, 0.6), 1e-5, "its colour alone")
        expect_near(materials["shine"]["emittance_W_per_m2"], np.pi * np.array((3.0, 1.5, 0.75)), 1e-4, "its emission")
        expect_near(materials["Area"]["emittance_W_per_m2"], [16 * np.pi * 40.0 / (4 * 2.0)] * 3, 1e-4, "watts over 4 areas")
        expect_near(info["low_m"], (-3.0, -2.0, -6.0), 1e-5, "Y is up, and parents move their children")
        expect_near(exporter.sky, (0.1, 0.2, 0.4), 1e-5, "the world")
        expect(any("metal" in note for note in exporter.notes), f"what is not taken over is told: {exporter.notes}")
        # Both ways back, onto meshes of all kinds.
        lights = {}
        for target, light in (("VERTEX", truth.corner_colours), ("LIGHTMAP", truth.at_middles)):
            expect(self.bake(error=2.0, target=target) == {"FINISHED"}, target)
            lights[target] = [light(bpy.data.objects[name], "Luxel").mean() for name in ("cube", "fine", "shine")]
        expect(min(lights["VERTEX"]) > 0.0, f"all have light: {lights}")
        expect_near(lights["LIGHTMAP"], lights["VERTEX"], 0.04, "the light of vertex colours and lightmap")
        image = bpy.data.images["Luxel"]
        expect(image.is_float and image.source != "TILED" and image.packed_file, "one page of floats, packed")
        expect(len(np.unique(truth.pixels_of(image)[..., 0])) > 300, "eight bits would have 256 lights")
        # The same on tiles, with and without their files.
        expect(self.bake(target="LIGHTMAP", page=64) == {"FINISHED"}, "several pages")
        image = bpy.data.images["Luxel"]
        expect(image.is_float and image.source == "TILED" and len(image.tiles) > 1, "a page is a tile")
        expect(len(image.packed_files) == len(image.tiles), "all tiles are packed")
        tiles = truth.packed_tiles(image, self.folder)
        found = [truth.at_middles(bpy.data.objects[name], "Luxel", tiles).mean() for name in ("cube", "fine", "shine")]
        expect_near(found, lights["VERTEX"], 0.04, "the light of vertex colours and of tiles")
        expect(np.all(truth.corner_colours(bpy.data.objects["pane"], "Luxel") == 0.0), "glass has none")
        scene.unit_settings.scale_length = 0.01
        words = self.add_on.Bake(bpy.context, scene.luxel, self.luxel).words()
        expect(words[words.index("--contact-gap") + 1] == "0.01", f"a tenth of a millimetre, in centimetres: {words}")

    # ---- lamps: each kind of lamp, alone above a few small white triangles, as Cycles has it ----

    def lamps(self):
        turned = (0.3, 0.2, 0.0)

        def spot(turn, size, blend):
            rooms.lamp("SPOT", (0, 0, 2), 100.0, turn, shadow_soft_size=0.0, spot_size=size, spot_blend=blend)

        lamps = {
            "point": lambda: rooms.lamp("POINT", (0, 0, 2), 100.0, shadow_soft_size=0.0, color=(1.0, 0.5, 0.2)),
            "ball": lambda: rooms.lamp("POINT", (0, 0, 2), 100.0, shadow_soft_size=0.1),
            "sun": lambda: rooms.lamp("SUN", (0, 0, 2), 3.0, turned, angle=0.0),
            "spot": lambda: spot(turned, 2.0, 0.0),
            "soft spot": lambda: spot((0.0, 0.0, 0.0), 2.4, 0.6),
            "square": lambda: rooms.lamp("AREA", (0, 0, 2), 50.0, turned, shape="SQUARE", size=0.5),
            "disk": lambda: rooms.lamp("AREA", (0, 0, 2), 50.0, shape="DISK", size=0.8),
            "ellipse, scaled": self.scaled_ellipse,
            "sheet from behind": lambda: rooms.Sheets("sheet", rooms.glow("glow", 7.0), 1.0).quad(
                (-0.2, -0.2, 2), (0.4, 0, 0), (0, 0.4, 0)).done(),
            "world": lambda: self.set_world((0.05, 0.1, 0.2), 2.0),
        }
        for name, make in lamps.items():
            self.scene = rooms.fresh_scene()
            item = self.small_triangles()
            make()
            bpy.context.view_layer.update()
            wanted = truth.at_corners(self.scene, item, 1024)
            expect(wanted.max() > 0.0, f"{name}: Cycles finds no light")
            expect(self.bake(error=0.5, max_edge=0.5) == {"FINISHED"}, name)
            found = truth.corner_colours(item, self.add_on.LAYER)
            shares = np.abs(found - wanted).max() / wanted.max()
            print(f"{name}: {found.sum() / wanted.sum():.4f} of Cycles' light, nowhere farther off than {shares:.4f}")
            expect(shares < 0.01, f"{name}: found {found}, Cycles has {wanted}")

    # ---- luminaires: lamps with IES textures ----

    def luminaires(self):
        luminaires.check(self)

    def scaled_ellipse(self):
        rooms.lamp("AREA", (0, 0, 2), 50.0, shape="ELLIPSE", size=0.2, size_y=0.1).scale = (2.0, 3.0, 1.0)

    def set_world(self, colour, strength):
        world = bpy.data.worlds.new("world")
        world.use_nodes = True
        world.node_tree.nodes["Background"].inputs["Color"].default_value = (*colour, 1.0)
        world.node_tree.nodes["Background"].inputs["Strength"].default_value = strength
        self.scene.world = world

    def small_triangles(self):
        size, places, faces = 0.002, [], []
        for x, y in ((0, 0), (0.7, 0), (-1.2, 0.3), (0.4, 1.6), (-0.5, -2.5)):
            faces.append(range(len(places), len(places) + 3))
            places += [(x, y, 0), (x + size, y, 0), (x, y + size, 0)]
        mesh = bpy.data.meshes.new("white")
        mesh.from_pydata(places, [], faces)
        mesh.materials.append(rooms.paint("white", 0.5))
        item = bpy.data.objects.new("white", mesh)
        bpy.context.collection.objects.link(item)
        return item

    # ---- cornell_box, office: the same light as Cycles' ----

    def cornell_box(self):
        self.compare(rooms.cornell_box, 300, self.vertex_colours, self.image_as_shown)

    def office(self):
        self.compare(rooms.office, 320, self.vertex_colours)

    def compare(self, make, samples, *ways):
        """Of each quad the mean of what is shown on it beside the mean of Cycles' texels in it."""
        make()
        cells = rooms.Cells()
        areas = truth.areas()
        theirs = truth.by_cell(self.scene, cells, samples)
        for baked in ways:
            print(f"{make.__name__}, {baked.__name__}:")
            ours = baked(cells)
            for name in theirs:
                told(name, areas[name], ours[name], theirs[name])
            whole, difference = told("all", *(np.concatenate([values[name] for name in theirs])
                                              for values in (areas, ours, theirs)))
            expect(abs(whole - 1.0) < 0.02 and difference < 0.02, "Luxel's light is not Cycles'")

    def vertex_colours(self, _cells):
        expect(self.bake(error=1.0) == {"FINISHED"}, "the bake")
        return {item.name: truth.corner_colours(item, self.add_on.LAYER) for item in rooms.meshes()}

    def image_as_shown(self, cells):
        """Each material shines with the page, and Cycles bakes that."""
        expect(self.bake(error=1.0, target="LIGHTMAP") == {"FINISHED"}, "the bake")
        for material in {slot.material for item in rooms.meshes() for slot in item.material_slots}:
            tree = material.node_tree
            shader = tree.nodes.new("ShaderNodeEmission")
            tree.links.new(tree.nodes[self.add_on.LAYER].outputs["Color"], shader.inputs["Color"])
            tree.links.new(shader.outputs[0], tree.get_output_node("CYCLES").inputs["Surface"])
        return truth.by_cell(self.scene, cells, 4, "EMIT")

    # ---- use: what a user may do to it ----

    def use(self):
        scene = self.scene
        first = add_sheet("first", principled("white"), (0.0, 0.0, 0.0), 2)
        second = add_sheet("second", first.material_slots[0].material, (3.0, 0.0, 0.0))
        second.data = first.data  # one mesh, two lights
        fine = add_cube("fine", principled("plain"), (0.0, 3.0, 0.0))
        fine.modifiers.new("finer", "SUBSURF").subdivision_type = "SIMPLE"
        rooms.lamp("POINT", (0.5, 0.5, 1.0), 50.0)
        layer = first.data.color_attributes.new("Luxel", "BYTE_COLOR", "POINT")
        bpy.context.view_layer.update()

        # Only what is selected, and without a program nothing.
        try:
            bpy.ops.luxel.bake(program="no such program")
            raise AssertionError("a bake without a program went well")
        except RuntimeError as error:
            expect("no such program" in str(error), f"the program is named: {error}")
        for item in (first, second, fine):
            item.select_set(item is second)
        expect(self.bake(only_selected=True, error=5.0) == {"FINISHED"}, "the bake")
        expect(second.data != first.data, "a mesh of two objects becomes one each")
        layer = first.data.color_attributes["Luxel"]
        expect((layer.data_type, layer.domain) == ("BYTE_COLOR", "POINT"), "what is not selected stays")
        layer = second.data.color_attributes["Luxel"]
        expect((layer.data_type, layer.domain) == ("FLOAT_COLOR", "CORNER"), "a layer of another kind is replaced")
        expect(second.data.color_attributes.active_color == layer, "it is what the viewport shows")

        # All, in what a display shows.
        expect(self.bake(only_selected=False, content="LOOK") == {"FINISHED"}, "the bake")
        near, far = (truth.corner_colours(item, "Luxel").max() for item in (first, second))
        expect(1.0 >= near > far > 0.0, f"the lamp is nearer to the first: {near}, {far}")
        expect(not fine.modifiers and len(fine.data.polygons) == 24, "modifiers that change corners are applied")

        # Stopped on the way: the process ends, its folder goes, nothing changes.
        before = truth.corner_colours(first, "Luxel")
        scene.luxel.error, scene.luxel.content = 0.05, "LIGHT"
        scene.luxel.max_edge = 0.02
        bake = self.add_on.Bake(bpy.context, scene.luxel, self.luxel)
        bake.begin()
        while bake.run.stage != "light":
            expect(not bake.poll(), "it had ended before it could be stopped")
            time.sleep(0.01)
        expect(0.0 <= bake.run.done <= 1.0, "progress is a share")
        bake.close()
        expect(bake.run.process.returncode not in (0, None), "the process was ended")
        expect(not os.path.exists(bake.folder), "its folder is gone")
        expect(np.array_equal(before, truth.corner_colours(first, "Luxel")), "nothing was changed")

        # No light at all is a sentence.
        bpy.data.objects.remove(bpy.data.objects["Point"])
        try:
            self.bake(error=5.0)
            raise AssertionError("a bake without a lamp went well")
        except RuntimeError as error:
            expect("luxel failed" in str(error), f"what luxel said is passed on: {error}")
        self.add_on.unregister()
        expect(not hasattr(bpy.types.Scene, "luxel"), "it goes without a trace")

        # As a user installs it: the preferences say where the program is.
        bpy.ops.preferences.addon_install(filepath=ADD_ON)
        bpy.ops.preferences.addon_enable(module="luxel_bake")
        rooms.lamp("POINT", (0.5, 0.5, 1.0), 50.0)
        bpy.context.preferences.addons["luxel_bake"].preferences.program = self.luxel
        scene.luxel.error = 5.0
        expect(bpy.ops.luxel.bake() == {"FINISHED"}, "the bake with the program of the preferences")

    # ---- window: a bake that leaves Blender usable, is taken back, and is stopped by Esc ----

    def window(self):
        """Goes on by itself once Blender's window is there."""
        rooms.cornell_box(0.1)
        steps = self.in_window()

        def step():
            try:
                return next(steps)
            except StopIteration:
                print("all holds: window", flush=True)
                os._exit(0)
            except BaseException:  # a timer's errors are but printed
                traceback.print_exc()
                os._exit(1)

        bpy.app.timers.register(step, first_interval=0.5)

    def in_window(self):
        """Gives how many seconds Blender is to go its own ways."""
        def has_light():
            return any(self.add_on.LAYER in mesh.color_attributes for mesh in bpy.data.meshes)

        def begin(error):
            bpy.context.scene.luxel.error = error
            window = bpy.context.window_manager.windows[0]
            with bpy.context.temp_override(window=window, screen=window.screen, area=window.screen.areas[0]):
                answer = bpy.ops.luxel.bake("INVOKE_DEFAULT", program=self.luxel)
            expect(answer == {"RUNNING_MODAL"}, f"it runs beside Blender: {answer}")

        def folders():
            return [name for name in os.listdir(tempfile.gettempdir()) if name.startswith("luxel-")]

        bpy.ops.ed.undo_push(message="the box")
        begin(3.0)
        expect(not has_light() and folders(), "Blender goes on before the bake has ended")
        while not has_light():
            yield 0.05
        yield 0.2
        expect(not folders(), "nothing is left behind")
        bpy.ops.ed.undo()
        expect(len(rooms.meshes()) == 4 and not has_light(), "a bake can be taken back")
        begin(0.05)
        yield 1.0
        expect(folders(), "it works for long")
        window = bpy.context.window_manager.windows[0]
        for value in ("PRESS", "RELEASE"):
            window.event_simulate(type="ESC", value=value)
        while folders():
            yield 0.05
        expect(not has_light(), "nothing was changed")

    # ---- Scenes ----

    def mixed_scene(self):
        picture = bpy.data.images.new("picture", 2, 2)
        picture.pixels[:] = [1, 0, 0, 1] + [0, 0.5, 0, 1] * 3
        painted = principled("painted")
        node = painted.node_tree.nodes.new("ShaderNodeTexImage")
        node.image, node.interpolation = picture, "Closest"
        shader = painted.node_tree.nodes["Principled BSDF"]
        painted.node_tree.links.new(node.outputs["Color"], shader.inputs["Base Color"])
        cube = add_cube("cube", painted, (5.0, 0.0, 0.0))
        kept = bpy.data.collections.new("kept")
        kept.objects.link(cube)
        copy = bpy.data.objects.new("copy", None)
        copy.instance_type, copy.instance_collection, copy.location = "COLLECTION", kept, (0.0, 5.0, 0.0)
        bpy.context.collection.objects.link(copy)
        fine = add_cube("fine", principled("plain", **{"Base Color": (0.4, 0.5, 0.6, 1.0)}), (0.0, -1.0, 0.0))
        fine.modifiers.new("finer", "SUBSURF").subdivision_type = "SIMPLE"
        parent = bpy.data.objects.new("parent", None)
        parent.location, parent.scale = (-2.0, 5.0, -1.0), (-1.0, 1.0, 1.0)
        bpy.context.collection.objects.link(parent)
        fine.parent = parent
        fine.location = (0.0, -1.0, 0.0)
        two = add_sheet("two", principled("two tone"), (0.0, 0.0, 3.0), 2)
        two.data.materials.append(principled("second", Metallic=0.3))
        two.data.polygons[1].material_index = 1
        shine = principled("shine", Emission=(1.0, 0.5, 0.25, 1.0), **{"Emission Strength": 3.0})
        add_sheet("shine", shine, (3.0, 3.0, 3.0))
        add_sheet("pane", principled("glass", Transmission=1.0), (0.0, 0.0, 4.0))
        add_sheet("hidden", principled("hidden"), (50.0, 0.0, 0.0)).hide_render = True
        rooms.lamp("AREA", (0, 0, 3.5), 40.0, shape="RECTANGLE", size=1.0, size_y=2.0)
        self.set_world((0.05, 0.1, 0.2), 2.0)


def principled(name, **inputs):
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    for socket, value in inputs.items():
        material.node_tree.nodes["Principled BSDF"].inputs[socket].default_value = value
    return material


def add_cube(name, material, place):
    bpy.ops.mesh.primitive_cube_add(location=place)
    cube = bpy.context.object
    cube.name = name
    cube.data.materials.append(material)
    return cube


def add_sheet(name, material, place, cells=1):
    sheet = rooms.Sheets(name, material, 1.0).quad((0, 0, 0), (cells, 0, 0), (0, 1, 0)).done()
    sheet.location = place
    return sheet


if __name__ == "__main__":
    LUXEL, CHECK, FOLDER = sys.argv[sys.argv.index("--") + 1:]
    getattr(Check(LUXEL, FOLDER), CHECK)()
    if CHECK != "window":
        print("all holds:", CHECK)
