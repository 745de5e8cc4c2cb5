"""Materials of a USD stage: what surfaces look like, and their friction; each defined once."""

from typing import Any

from pxr import Gf, Sdf, UsdGeom, UsdPhysics, UsdShade

from apartgen.stages.export._obj import Files
from apartgen.stages.scene.pieces import cut_out
from apartgen.stages.things.asset import Material


class Looks:
    """Materials under the prim `path`; textures go to `files`, a folder beside the stage's file."""

    def __init__(self, stage: Any, path: str, files: Files) -> None:
        self.stage, self.path, self.files = stage, path, files
        self._known: dict[str, Any] = {}

    def bind(self, prim: Any, material: Material, name: str) -> None:
        """Give a mesh its surface."""
        self._scope()
        if name not in self._known:
            self._known[name] = self._surface(f"{self.path}/{name}", material)
        UsdShade.MaterialBindingAPI.Apply(prim).Bind(self._known[name])

    def bind_friction(self, prim: Any, friction: float) -> None:
        """Give the colliders below a prim their friction."""
        self._scope()
        name = f"friction_{round(friction * 100):03d}"
        if name not in self._known:
            made = UsdShade.Material.Define(self.stage, f"{self.path}/{name}")
            api = UsdPhysics.MaterialAPI.Apply(made.GetPrim())
            api.CreateStaticFrictionAttr(friction)
            api.CreateDynamicFrictionAttr(0.9 * friction)
            api.CreateRestitutionAttr(0.0)
            self._known[name] = made
        binding = UsdShade.MaterialBindingAPI.Apply(prim)
        binding.Bind(self._known[name], UsdShade.Tokens.weakerThanDescendants, "physics")

    def _scope(self) -> None:
        if not self._known:
            UsdGeom.Scope.Define(self.stage, self.path)

    def _surface(self, path: str, m: Material) -> Any:
        made = UsdShade.Material.Define(self.stage, path)
        shader = UsdShade.Shader.Define(self.stage, f"{path}/surface")
        shader.CreateIdAttr("UsdPreviewSurface")
        shader.CreateInput("roughness", Sdf.ValueTypeNames.Float).Set(m.roughness)
        shader.CreateInput("metallic", Sdf.ValueTypeNames.Float).Set(m.metalness)
        if m.emission:
            glow = (m.emission * _linear(c) for c in m.color[:3])
            shader.CreateInput("emissiveColor", Sdf.ValueTypeNames.Color3f).Set(Gf.Vec3f(*glow))
        opacity = shader.CreateInput("opacity", Sdf.ValueTypeNames.Float)
        opacity.Set(m.color[3])
        color = shader.CreateInput("diffuseColor", Sdf.ValueTypeNames.Color3f)
        if m.texture:
            image = self._texture(path, self.files.texture(m.texture)).ConnectableAPI()
            color.ConnectToSource(image, "rgb")
            if relief := self.files.relief(m.texture):
                normal = shader.CreateInput("normal", Sdf.ValueTypeNames.Normal3f)
                normal.ConnectToSource(self._relief(path, relief).ConnectableAPI(), "rgb")
            if cut_out(m.texture):
                opacity.ConnectToSource(image, "a")
                shader.CreateInput("opacityThreshold", Sdf.ValueTypeNames.Float).Set(0.5)
        else:
            color.Set(Gf.Vec3f(*(_linear(c) for c in m.color[:3])))
        made.CreateSurfaceOutput().ConnectToSource(shader.ConnectableAPI(), "surface")
        return made

    def _texture(self, path: str, file: str) -> Any:
        """What reads the image of a colour."""
        reader = UsdShade.Shader.Define(self.stage, f"{path}/st")
        reader.CreateIdAttr("UsdPrimvarReader_float2")
        reader.CreateInput("varname", Sdf.ValueTypeNames.String).Set("st")
        reader.CreateOutput("result", Sdf.ValueTypeNames.Float2)
        image = self._image(path, "image", file, "sRGB")
        image.CreateOutput("a", Sdf.ValueTypeNames.Float)
        return image

    def _relief(self, path: str, file: str) -> Any:
        """What reads a normal map; a byte of it is from -1 to 1."""
        image = self._image(path, "relief", file, "raw")
        image.CreateInput("scale", Sdf.ValueTypeNames.Float4).Set(Gf.Vec4f(2, 2, 2, 1))
        image.CreateInput("bias", Sdf.ValueTypeNames.Float4).Set(Gf.Vec4f(-1, -1, -1, 0))
        return image

    def _image(self, path: str, name: str, file: str, space: str) -> Any:
        image = UsdShade.Shader.Define(self.stage, f"{path}/{name}")
        image.CreateIdAttr("UsdUVTexture")
        place = Sdf.AssetPath(f"./{self.files.folder.name}/{file}")
        image.CreateInput("file", Sdf.ValueTypeNames.Asset).Set(place)
        image.CreateInput("sourceColorSpace", Sdf.ValueTypeNames.Token).Set(space)
        for wrap in ("wrapS", "wrapT"):
            image.CreateInput(wrap, Sdf.ValueTypeNames.Token).Set("repeat")
        reader = UsdShade.Shader.Get(self.stage, f"{path}/st").ConnectableAPI()
        image.CreateInput("st", Sdf.ValueTypeNames.Float2).ConnectToSource(reader, "result")
        image.CreateOutput("rgb", Sdf.ValueTypeNames.Float3)
        return image


def _linear(c: float) -> float:
    """sRGB to linear light."""
    return c / 12.92 if c <= 0.04045 else float(((c + 0.055) / 1.055) ** 2.4)
