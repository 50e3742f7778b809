#include "scene/finish.hpp"

#include <fmt/format.h>

namespace simreel::scene {

void Finish::describe(Fields& fields) {
  fields.asset("normalMap", normals.file,
               "Picture of normals in tangent space: red along u, green up the picture, blue outwards.");
  fields.number("normalStrength", normalStrength, {-10, 10}, "",
                "Factor on the slopes of the normal map; a negative one turns bumps into dents.");
  fields.asset("metallicRoughnessMap", metalRough.file,
               "Picture of factors as glTF has it: green on \"roughness\", blue on \"metallic\".");
  fields.asset("occlusionMap", occlusion.file,
               "Picture whose red channel is the fraction of ambient light that reaches the surface.");
  fields.number("occlusionStrength", occlusionStrength, fraction, "", "Strength of the occlusion map.");
  fields.color("emission", emission, notNegative,
               "Light that the surface emits, linear RGB; with quality high it lights other things, too.");
  fields.number("emissionStrength", emissionStrength, notNegative, "", "Factor on \"emission\".");
  fields.asset("emissionMap", emissionMap.file, "sRGB picture, a factor on \"emission\".");
  fields.choice("alpha", alpha, {"opaque", "cut", "blend"},
                "Use of the opacity, which is the texture's alpha channel times \"opacity\". opaque: the "
                "opacity is unused; cut: below \"alphaCutoff\" there is a hole; blend: the surface hides "
                "so much of the things behind it.");
  fields.number("opacity", opacity, fraction, "", "Opacity: 0 is invisible, 1 hides the things behind it.");
  fields.number("alphaCutoff", cutoff, fraction, "",
                "Least opacity that is drawn if \"alpha\" is \"cut\".");
  fields.boolean("doubleSided", doubleSided, "Draws backs, too; false: as the object itself says.");
  fields.number("clearCoat", coat, fraction, "", "Strength of a clear coat over it, such as lacquer.");
  fields.number("clearCoatRoughness", coatRoughness, fraction, "", "0 mirrors, 1 is matt.");
  fields.color("sheen", sheen, fraction, "Colour of fibres that stand up from cloth, linear RGB.");
  fields.number("sheenRoughness", sheenRoughness, {0.07, 1}, "",
                "Low: visible only along the edges; high: everywhere.");
  fields.number("transmission", transmission, fraction, "",
                "With quality high: of the light that is not mirrored, the fraction that passes through, "
                "as through glass.");
  fields.number("ior", ior, {1, 4}, "",
                "Index of refraction relative to air: 1.33 water, 1.5 glass, 2.42 diamond.");
  fields.boolean("thinWalled", thin,
                 "Makes it a thin sheet that light goes straight through; false: the surface of a solid, "
                 "which bends light where it enters and leaves.");
  fields.color("attenuationColor", attenuation, {1e-6, 1},
               "Colour that white light has after \"attenuationDistance\" in the solid, linear RGB.");
  fields.number("attenuationDistance", attenuationDistance, positive, "m",
                "Distance in the solid after which white light has \"attenuationColor\".");
  const auto needs = [&](const char* name, bool present, const char* what) {
    if (fields.given(name) && !present)
      fields.error(name, fmt::format("\"{}\" is for a material with {}", name, what));
  };
  needs("normalStrength", !normals.empty(), "a \"normalMap\"");
  needs("occlusionStrength", !occlusion.empty(), "an \"occlusionMap\"");
  needs("emissionMap", emits(), "an \"emission\", which it is a factor on");
  needs("opacity", alpha != Alpha::opaque, "\"alpha\": \"cut\" or \"blend\"");
  needs("alphaCutoff", alpha == Alpha::cut, "\"alpha\": \"cut\"");
  needs("clearCoatRoughness", coat > 0, "a \"clearCoat\"");
  needs("ior", transmission > 0, "a \"transmission\"");
  needs("thinWalled", transmission > 0, "a \"transmission\"");
  needs("attenuationColor", transmission > 0 && !thin, "a \"transmission\" that is not \"thinWalled\"");
  needs("attenuationDistance", attenuation != glm::vec3(1), "an \"attenuationColor\"");
  needs("sheenRoughness", sheen != glm::vec3(0), "a \"sheen\"");
  fields.idleUnless(emission != glm::vec3(0), "emission", {"emissionStrength"},
                    "a material with an \"emission\"");
}

}  // namespace simreel::scene
