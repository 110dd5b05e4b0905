"""Mjcf: a stranger's MJCF body, alone or in a zip with its meshes, read as an object's shape.

Only elements that describe a rigid body are taken; files are found in the upload alone. The XML is
checked before MuJoCo sees it, since MuJoCo includes, and reads from the disk, whatever it is told.
"""

import io
import zipfile
from pathlib import PurePosixPath
from xml.etree import ElementTree as Xml

import mujoco

from app.domain.errors import AssetRefused, Fault
from app.worlds.simulators.mujoco.rigid_body import ONE_RIGID, RigidBody, rigid_body
from app.worlds.simulators.mujoco.upload import Upload

TAKEN = {
    "mujoco", "mujocoinclude", "compiler", "option", "default", "asset", "mesh", "material",
    "worldbody", "body", "inertial", "freejoint", "joint", "geom", "site",
}  # fmt: skip
"""The elements an upload may have."""
COMPILER = {"angle", "autolimits", "eulerseq", "coordinate", "inertiafromgeom"}
"""What it may tell the compiler; folders are of no use in an upload."""
MESHES = {".obj", ".stl", ".msh"}
MAX_XML = 1_000_000  # bytes
MAX_UNPACKED = 60_000_000  # bytes
MAX_FILES, MAX_ELEMENTS, MAX_GEOMS = 64, 2000, 64


def read_mjcf(data: bytes, upload: Upload) -> RigidBody:
    """The one body of an MJCF file.

    Raises:
        AssetRefused: it is none, has what is not taken, or not the size of a thing on a table.
    """
    if upload.scale != 1.0 or upload.up != "z":
        field = "scale" if upload.scale != 1.0 else "up"
        message = "is for meshes; MJCF is in metres, z up: scale the mesh in the XML, or turn it"
        raise AssetRefused(Fault(field=field, message=message))
    text, files = _unpacked(data) if upload.format == "zip" else (data, {})
    tree = _checked(text, files)
    try:
        spec = mujoco.MjSpec.from_string(Xml.tostring(tree, encoding="unicode"), assets=files)
        model = spec.compile()
    except ValueError as error:
        raise _refused(f"cannot be built in physics: {error}") from error
    return rigid_body(model, hulls=upload.decomposition == "hull")


def _unpacked(data: bytes) -> tuple[bytes, dict[str, bytes]]:
    """The XML of a zip, and its other files by name; nothing is written anywhere."""
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            entries = [each for each in archive.infolist() if not each.is_dir()]
            if len(entries) > MAX_FILES:
                raise _refused(f"has {len(entries)} files; at most {MAX_FILES} are taken")
            if sum(each.file_size for each in entries) > MAX_UNPACKED:
                raise _refused(f"unpacks to more than {MAX_UNPACKED // 1_000_000} MB")
            found = {PurePosixPath(each.filename).name: archive.read(each) for each in entries}
    except (zipfile.BadZipFile, NotImplementedError, RuntimeError, EOFError, OSError) as error:
        raise _refused(f"cannot be read as a zip: {error}") from error
    texts = [name for name in found if name.lower().endswith(".xml")]
    if len(texts) != 1 or len(found) != len(entries):
        named = ", ".join(sorted(texts)) or "none"
        raise _refused(f"should hold one XML file and files of different names; XML: {named}")
    return found.pop(texts[0]), found


def _checked(text: bytes, files: dict[str, bytes]) -> Xml.Element:
    """The tree, every file it names being in the upload."""
    if len(text) > MAX_XML:
        raise _refused(f"has an XML file of more than {MAX_XML:,} bytes")
    try:
        plain = text.decode("utf-8-sig")
        # Entities can name files and grow without end.
        if "<!" in plain.replace("<!--", ""):
            raise _refused("has a <! declaration; write plain XML, comments are fine")
        tree = Xml.fromstring(plain)
    except (Xml.ParseError, ValueError) as error:
        raise _refused(f"is no XML: {error}") from error
    elements = list(tree.iter())
    if len(elements) > MAX_ELEMENTS:
        raise _refused(f"has {len(elements):,} elements; at most {MAX_ELEMENTS:,} are taken")
    for element in elements:
        _check_element(element, files)
    _check_bodies(tree)
    tree.tag = "mujoco"
    return tree


def _check_element(element: Xml.Element, files: dict[str, bytes]) -> None:
    tag = element.tag
    if tag not in TAKEN:
        raise _refused(f"has <{str(tag)[:40]}>; taken are {', '.join(sorted(TAKEN))}")
    if tag == "compiler" and (unknown := set(element.keys()) - COMPILER):
        wrong = ", ".join(sorted(unknown))[:80]
        raise _refused(f"has <compiler> with {wrong}; taken are {', '.join(sorted(COMPILER))}")
    if tag == "joint" and "class" not in element.attrib and element.get("type") != "free":
        kind = element.get("type", "hinge")[:20]
        raise _refused(f"has a {kind} joint; {ONE_RIGID}")
    for name in ("file", "fileleft", "fileright", "texture", "plugin"):
        if name in element.attrib and (tag, name) != ("mesh", "file"):
            raise _refused(f"has <{tag}> with {name}; only a <mesh> may have a file")
    if tag == "mesh" and "file" in element.attrib:
        _find_file(element, files)


def _find_file(mesh: Xml.Element, files: dict[str, bytes]) -> None:
    """Let it name the file of the upload."""
    path = mesh.attrib["file"]
    name = PurePosixPath(path.replace("\\", "/")).name
    if PurePosixPath(name).suffix.lower() not in MESHES:
        raise _refused(f"has the mesh {name[:80]!r}; {', '.join(sorted(MESHES))} are taken")
    if name not in files:
        there = ", ".join(sorted(files))[:200] or "none"
        raise _refused(f"names the file {path[:80]!r}, which is not in the upload: {there}")
    mesh.set("file", name)
    mesh.attrib.pop("content_type", None)


def _check_bodies(tree: Xml.Element) -> None:
    bodies = [body for world in tree.iter("worldbody") for body in world.iter("body")]
    bodies = bodies or list(tree.iter("body"))
    if len(bodies) != 1:
        raise _refused(f"has {len(bodies)} bodies; an object is one body with its geoms in it")
    if loose := sum(child.tag == "geom" for world in tree.iter("worldbody") for child in world):
        raise _refused(f"has {loose} geoms outside its body; put them into it")
    geoms = len(list(bodies[0].iter("geom")))
    if not 1 <= geoms <= MAX_GEOMS:
        raise _refused(f"has a body of {geoms} geoms; from 1 to {MAX_GEOMS} are taken")
    if tree.find("worldbody") is None:
        world = Xml.SubElement(tree, "worldbody")
        (parent,) = [each for each in tree.iter() if bodies[0] in list(each)]
        parent.remove(bodies[0])
        world.append(bodies[0])


def _refused(message: str) -> AssetRefused:
    return AssetRefused(Fault(field="body", message=message))
