#include "source/app/manual/Manual.h"

#include <utility>

#include "R2/ImageFile.h"
#include "R3/ShapeKind.h"
#include "source/parse/meshes/MeshFormat.h"
#include "source/parse/scn/Command.h"
#include "source/scene/Light.h"

namespace ray {
namespace {

/// Returns paragraphs, one per line of the text.
std::string Paragraphs(const std::string& text) {
  std::string roff;
  for (const char c : Roff(text)) roff += c == '\n' ? std::string("\n.PP\n") : std::string(1, c);
  const std::string after_last = ".PP\n";
  return roff.substr(0, roff.size() - after_last.size());
}

enum class Family { statement, shape, light };

Family FamilyOf(const Command& command) {
  if (R3::FindShapeKind(command.name)) return Family::shape;
  return FindLightKind(command.name) ? Family::light : Family::statement;
}

std::string Entries(Family family) {
  std::string text;
  for (const Command& command : Commands())
    if (FamilyOf(command) == family) text += ".TP\n.B " + Roff(command.usage) + "\n" + Roff(command.about) + ".\n";
  return text;
}

std::string ImageExtensions() {
  std::string text;
  for (const R2::ImageFormat& format : R2::ImageFormats())
    for (const char* extension : format.extensions) text += (text.empty() ? "." : ", .") + std::string(extension);
  return text;
}

constexpr const char* lexical =
    "A file is a sequence of words separated by white space; line breaks are not significant. A statement is a "
    "command followed by its numbers and names.\n"
    "A # that begins a word, or follows a number or a command, starts a comment, which ends with the line.\n"
    "Commands are in lower case. Numbers are decimal, such as 2, -.5, +20 or 1e-3; angles are in radians. Colors are "
    "three numbers, red, green and blue, that may exceed 1. A file name that contains blanks or a # is written in "
    "quotes, as in \"my wood.png\"; \\\" is a quote in it, \\\\ a backslash, \\n the end "
    "of a line.\n"
    "A formula in parentheses, which ends on its line, stands for a number: (1/3), ($day * 12 + 30) with the value "
    "of a variable that define has named. It may contain pi, + - * /, ^ with whole exponents up to 64, sin, cos and "
    "tan of radians, exp, log, sqrt, abs, min and max.\n"
    "Statements may come in any order, except that a material must precede its first use. If there are several "
    "cameras, backgrounds, ambients or environments, the last one applies.\n";

constexpr const char* placing =
    "A matrix has 16 numbers, row by row, and transforms points written as columns: the fourth column is the "
    "translation. Its last row is 0 0 0 1. Groups may contain groups; the inner matrix applies first.\n"
    "Instead of a matrix, begin takes any number of transform words, which apply from right to left: begin -1 "
    "translate 0 1 0 rotate 45 0 1 0 scale 2 makes its shapes twice as large, rotates them by 45 degrees about the y "
    "axis, counter-clockwise seen from above, and then lifts them by 1. look_at moves the origin to ex ey ez and "
    "rotates the z axis towards the point tx ty tz, with y as close to ux uy uz as possible.\n"
    "Groups do not move cameras, lights and environments.\n"
    "The camera's view is a direction, not a target point. Its angle is half of the horizontal view; the height of "
    "the image determines the vertical one.\n"
    "A light's direction is the way the light travels. Its attenuation ca la qa divides it by ca + la d + qa d^2 at "
    "a distance d. The last two numbers of a spot_light are the cut-off angle, then the exponent.\n"
    "camera look_at takes a target point, and the whole horizontal view in degrees.\n"
    "Without a camera the scene is viewed along -z from a distance of three times the radius of its box. Without a "
    "light two dir_light shine, of color 1 along -3 -4 -5 and of color .5 along 3 2 3; a black light suppresses "
    "them.\n";

constexpr std::pair<const char*, const char*> material_words[] = {
    {"ka", "Weight of the ambient light, added once."},
    {"kd", "Diffuse weight, multiplied by the cosine and by the texture, if there is one."},
    {"ks", "Weight of the highlights of lights and of the mirrored ray; see below for each mode."},
    {"kt", "Weight of the transmitted light, at each surface crossed."},
    {"e", "Emission: always added. An emissive shape is also a lamp, see LAMPS."},
    {"n", "Phong's exponent of the highlight, at least 0."},
    {"ir", "Index of refraction relative to 1 outside; 0 means 1."},
    {"texture",
     "The name of an image, or 0 for none. It repeats in u and v, interpolated between the centers of four texels. "
     "At the poles of a ball and the apex of a cone the last row is interpolated with its own opposite side; at the "
     "rims of cones and cylinders it stays as it is."},
};

constexpr const char* about_ids =
    "Materials are numbered from 0 in the order of each file. Any negative mat_id inherits that of the enclosing "
    "group; at the top level of a file, including an included one, it means a gray: ka .2, kd .5, ks .5, n 10.\n"
    "kd (N.L) + ks (V.R)^n of each light that is not in shadow is added, without a factor of 1/pi or any "
    "normalization; then ks times the color of the mirrored ray and kt times that of the refracted ray.\n"
    "So in mode whitted ks is the height of a light's highlight, for any n. In mode path this also applies to the "
    "lights of this language, which rays cannot hit. Of light from emissive shapes, the environment and other "
    "surfaces, ks (or the color of mirror) is the fraction that is reflected: in the mirrored ray's direction, or "
    "with -glossy over the lobe ks (n + 1)/(2 pi) (V.R)^n per solid angle, without a further cosine. From straight "
    "above all of ks is reflected, at grazing angles down to half of it, since part of the lobe is below the "
    "surface. Renderers whose Phong lobe is ks (n + 2)/(2 pi) (V.R)^n (N.L) show a fainter highlight for the same "
    "ks, by the cosine of the viewing angle.\n"
    "A scene without lights has two default ones; in mode path only if nothing in it emits light.\n";

constexpr const char* about_lamps =
    "The modes whitted and path interpret the emission e of a shape differently.\n"
    "In mode whitted it is, as in the course, the full color of a light without falloff. Each point of a triangle "
    "shines like a point_light of the color e with the attenuation 1 0 0, to both sides but not onto the triangle "
    "itself; the arriving light is the mean over -shadow_samples of its points. So a lamp is equally strong at any "
    "size and distance. Each tri and each triangle of a mesh is a lamp: a mesh that is cut into twice as many "
    "triangles gives twice the light, unless -emissive_meshes whole makes one lamp of a mesh. A quad or polygon is "
    "one lamp, regardless of its triangles. Spheres, boxes and other shapes glow but light nothing, unless "
    "-emissive_solids on makes lamps of all except planes.\n"
    "In mode path e is a radiance. Every emissive shape is a lamp, on both sides of its surface, and its light grows "
    "with its area and falls off with the square of the distance, as real light does. A lamp of area A that faces a "
    "surface at a distance d that is large compared with its size lights it A / (pi d^2) times as strongly as in "
    "mode whitted. With -emission color mode path interprets e as mode whitted does, so that its paths only add the "
    "light that surfaces reflect to each other; mirrors still show the lamps.\n"
    "raypro -check reports lamps whose light differs by more than a factor of two between the modes, and meshes that "
    "are as many lamps as they have triangles.\n";

constexpr const char* about_files =
    "Files that a scene names are searched in the folder of the file that names them, then in the current folder, "
    "and must lie below the top scene's folder or the current one, unless -allow_path allows another. A name such as "
    "../textures/wood.png that does not exist is also searched as textures/wood.png, with a warning.\n";

constexpr std::pair<const char*, const char*> extensions[] = {
    {"mesh id file smooth",
     "Without the word smooth a mesh is flat, as in the course, and the order of a face's corners decides which side "
     "is its front. The front of a smooth mesh is the side of its vertex normals. A surface with the opposite "
     "orientation, as exporters that mirror leave it, is turned around as a whole, and raypro -check counts its "
     "triangles."},
    {"mesh id file smooth degrees",
     "Normals are averaged over the triangles around each corner that differ from its own by up to that many degrees."},
    {"mesh id file materials",
     "Faces have the materials and vertex colors of the file; the material id is for all others."},
    {"absorb, bump, coat, flat_color, gloss, mirror, normal_map, one_sided, priority, specular_map, texture_ambient, "
     "texture_project, texture_scale, vertex_colors",
     "Properties of a material defined earlier in the same file."},
    {"priority",
     "Clear solids may contain one another, touch and overlap: rays are refracted between the materials on both "
     "sides of a surface, and a surface with the same material on both sides has no effect. So water may overlap the "
     "wall of its glass slightly, if the glass has the higher priority. An object on a floor is seen as if there "
     "were a gap. This requires closed solids: spheres, boxes, cylinders, cones, paraboloids, tori, and meshes whose "
     "triangles bound a volume."},
    {"one_sided",
     "The front is the side from which a face's corners are counter-clockwise, the outside of a solid, or the side "
     "of a plane's or disc's normal. Rays from the eye and from lit surfaces pass through a surface that they would "
     "hit from behind: it casts a shadow only towards points that see its front, and a lamp shines forward. Glass "
     "needs both sides, and keeps them with -one_sided. Large meshes are slower than with two sides."},
    {"mirror", "The weight of the mirrored ray, instead of ks, which stays that of the highlights."},
    {"coat",
     "Reflects Schlick's fraction for the index ir, in addition to ks; the rest reaches the diffuse layer below. "
     "Highlights are unchanged."},
    {"gloss",
     "Like -glossy for one material and with a separate exponent; n remains that of highlights. Rays that share a "
     "reflection each have a part of its weight, which -min_luminance may cut at the next bounce."},
    {"normal_map", "Needs no vertex normals or tangents: tangents are computed from the texture coordinates."},
    {"specular_map",
     "Interpolated, repeated and with -srgb decoded like the texture. It multiplies ks and the color of mirror per "
     "channel, so that black reflects nothing and has no highlight; in mode path also the weight of the glossy lobe. "
     "Reflections of coat, -fresnel and -internal_reflection, kt and kd are unchanged."},
    {"texture_project",
     "Without it all texture coordinates of a polygon, and of a mesh whose file has none, are 0, as in the course: "
     "the shape has one color. With it they are the coordinates of the point in the frame of the shape, so that an "
     "image is one unit wide and high and continues from polygon to polygon; texture_scale sets the number per unit. "
     "They depend on the axis that the front of a triangle, or of a polygon as a whole, faces most: u v is z y "
     "towards -x, -z y towards +x, x z towards -y, x -z towards +y, -x y towards -z and x y towards +z. So images "
     "are never mirrored, and upright on surfaces that face sideways. Other shapes keep their coordinates."},
    {"flat_color, texture_ambient",
     "The color in mode flat, if it is not kd + ks + kt; a texture that also colors ambient light."},
    {"csg",
     "Combines the solids, closed meshes, groups and further csg up to its end. A union contains the points in any "
     "of them, an intersection those in all, a difference those in the first and in none of the others. Faces may "
     "coincide exactly; those that differ by rounding alone are one. Each solid shows its own material, also on the "
     "wall of the hole that it leaves; the inside, with ir, absorb and priority, is the material of csg. Its solids "
     "cannot emit, move separately or have vertex colors."},
    {"implicit",
     "The formula is written in quotes and may use x, y, z, pi, numbers, + - * /, parentheses, ^ with whole "
     "exponents up to 64, sin, cos, tan, exp, log, sqrt, abs, min and max; 3 x is 3 * x. The solid is where it is 0 "
     "or below, within the box, whose faces close it. Interval arithmetic finds the nearest surface for certain. "
     "Images are projected through the box along z, with u and v the fractions of the box along x and y; the same "
     "applies to a blob."},
    {"plane",
     "Infinite, so it has no bounding box: accelerators skip it, and every ray is tested against it separately."},
    {"view",
     "Before or after the camera. An image with another aspect shows the same part of the scene, squeezed; a shift "
     "of 1 0 moves the axis to the left edge."},
    {"shadow_bias",
     "Secondary rays only hit surfaces at least this far away. The default 0 is safe: rays start outside the error "
     "of the hit that they leave. A greater distance reproduces the images of programs that need it."},
    {"set",
     "Sets an option that affects the image, by its name without the dash, such as max_depth 2; presets and "
     "the command line override it, and -explain shows the origin of each setting."},
    {"set srgb", "Must precede the first image, whose colors it decodes."},
    {"motion", "Between begin and end."},
    {"environment", "A latitude-longitude image, an angular probe or a cross; -env overrides it."},
    {"sphere_light",
     "A light with a size that is invisible itself; from far away it equals a point_light of that "
     "color."},
};

constexpr const char* example =
    "# A red ball on a gray floor.\n"
    "camera       0 2 6   0 -.3 -1   0 1 0   .4   .01 100\n"
    "background   .5 .6 .8\n"
    "point_light  1 1 1   4 6 5   1 0 0\n"
    "material     0 0 0  .6 .6 .6  0 0 0     0 0 0  0 0 0  1 1 0    # 0\n"
    "material     0 0 0  .8 .1 .1  .2 .2 .2  0 0 0  0 0 0  40 1 0   # 1\n"
    "box 0   -4 -.2 -4  4 0 4\n"
    "begin 1   1 0 0 0   0 1 0 1   0 0 1 0   0 0 0 1\n"
    "  sphere -1   0 0 0 1\n"
    "end\n";

}  // namespace

std::string SceneManualPage() {
  return ".TH SCN 5 \"\" \"raypro " RAYPRO_VERSION
         "\" \"File Formats\"\n"
         ".SH NAME\nscn \\- scenes of the COS426 course, as raypro and rayview read them\n"
         ".SH DESCRIPTION\n" +
         Paragraphs(lexical) + ".SH COMMANDS\n" + Entries(Family::statement) + ".SS shapes\n" + Entries(Family::shape) +
         ".SS lights\n" + Entries(Family::light) + ".SH PLACES AND DIRECTIONS\n" + Paragraphs(placing) +
         ".SH MATERIALS\n" + Tagged(material_words) + ".PP\n" + Paragraphs(about_ids) + ".SH LAMPS\n" +
         Paragraphs(about_lamps) + ".SH FILES\n" + Paragraphs(about_files) + ".TP\n.B meshes\n" +
         Roff(MeshExtensions()) + "\n.TP\n.B images\n" + Roff(ImageExtensions()) +
         "\n.SH EXTENSIONS\nThese commands extend the course's language:\n" + Tagged(extensions) + ".SH MISTAKES\n" +
         Roff("Each is reported with file, line and column; raypro -check finds them without rendering.\n") +
         ".SH EXAMPLE\n.nf\n" + Roff(example) + ".fi\n.SH SEE ALSO\n.BR raypro (1),\n.BR rayview (1)\n";
}

}  // namespace ray
