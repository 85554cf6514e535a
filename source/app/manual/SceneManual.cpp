#include "source/app/manual/SceneManual.h"

#include <utility>

#include "R2/ImageFile.h"
#include "R3/ShapeKind.h"
#include "source/app/manual/Manual.h"
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
    "A file is a sequence of words separated by white space; line breaks are not significant. A statement is a command "
    "followed by its numbers and names.\n"
    "A # that begins a word, or follows a number or a command, starts a comment, which ends with the line.\n"
    "Commands are in lower case. Numbers are decimal, such as 2, -.5, +20 or 1e-3; angles are in radians. Colors are "
    "three numbers, red, green and blue, that may exceed 1. A file name that contains blanks or a # is written "
    "in quotes, as in "
    "\"my wood.png\"; \\\" is a quote in it, \\\\ a backslash, \\n the end of a line.\n"
    "A formula in parentheses, which ends on its line, stands for a number: (1/3), ($day * 12 + 30) with the value of "
    "a variable that define has named. It has pi, + - * /, ^ with whole exponents up to 64, sin, cos and tan of "
    "radians, exp, log, sqrt, abs, min and max.\n"
    "Statements may come in any order, except that a material must precede its first use. Of several cameras, "
    "backgrounds, ambients or environments the last one counts.\n";

constexpr const char* placing =
    "A matrix has 16 numbers, row by row, and transforms points written as columns: the fourth column is the "
    "translation. Its last row is 0 0 0 1. Groups may contain groups; the inner matrix applies first.\n"
    "Instead of a matrix, begin takes any number of transform words, which apply from right to left: "
    "begin -1 translate 0 1 0 rotate 45 0 1 0 scale 2 makes its shapes twice as large, turns them by 45 "
    "degrees about the y axis, counter-clockwise seen from above, and then lifts them by 1. look_at brings the "
    "origin to ex ey ez and turns the z axis towards the point tx ty tz, y as near to ux uy uz as it can be.\n"
    "Cameras, lights and what surrounds the scene are never moved by a group.\n"
    "The camera's view is a direction, not a place to look at. Its angle is half of the horizontal view; the height of "
    "the image decides the vertical one.\n"
    "A light's direction is the way the light travels. Its attenuation ca la qa divides it by ca + la d + qa d^2 at a "
    "distance d. Of the two numbers behind a spot_light the cut-off angle is the first, the exponent the second.\n"
    "camera look_at takes a point to look at, and the whole horizontal view in degrees.\n"
    "Without any camera the scene is looked at along -z from three times the radius of its box; without any light two "
    "dir_light shine, of color 1 along -3 -4 -5 and of color .5 along 3 2 3. A black light keeps them away.\n";

constexpr std::pair<const char*, const char*> material_words[] = {
    {"ka", "Weight of the ambient light, added once."},
    {"kd", "Diffuse weight, multiplied by the cosine and by the texture, where there is one."},
    {"ks", "Weight of the highlights of lights and of the mirrored ray; see below for each mode."},
    {"kt", "Weight of the transmitted light, at each surface crossed."},
    {"e", "Emission: always added. What emits is a lamp as well, see LAMPS."},
    {"n", "Phong's exponent of the highlight, at least 0."},
    {"ir", "Index of refraction against 1 outside; 0 means 1."},
    {"texture",
     "The name of an image, or 0 for none. It repeats in u and v, blended between the middles of four texels; but at "
     "the poles of a ball and the apex of a cone the last row is blended with its own other side, and at the rims of "
     "cones and cylinders it stays as it is."},
};

constexpr const char* about_ids =
    "Materials are numbered from 0 in the order of each file. Any negative mat_id inherits that of the group "
    "around; at the top level of a file, an included one too, it means a gray: ka .2, kd .5, ks .5, n 10.\n"
    "kd (N.L) + ks (V.R)^n of each light that is not in shadow is added, without a factor of 1/pi or any "
    "normalization; then ks times what the mirrored ray sees and kt times what the refracted ray sees.\n"
    "So in mode whitted ks is the height of a light's highlight, whatever n. In mode path it is that too for the "
    "lights of this language, which no ray can hit. Of what rays do hit, shapes that emit, the environment and other "
    "surfaces, ks (or what mirror says) is the share reflected: in the mirrored ray's direction, or with -glossy over "
    "the lobe ks (n + 1)/(2 pi) (V.R)^n per solid angle, without a further cosine. All of ks is reflected from "
    "straight above, and down to half of it at grazing angles, where part of the lobe is below the surface. Renderers "
    "whose Phong lobe is ks (n + 2)/(2 pi) (V.R)^n (N.L) show a fainter highlight for the same ks, by the cosine at "
    "which it is seen.\n"
    "A scene that names no light is lit by two default ones; in mode path only if nothing in it emits light.\n";

constexpr const char* about_lamps =
    "The modes whitted and path read the emission e of a shape differently.\n"
    "Mode whitted reads it as the course does, as the full color of a light without falloff. From each of its points a "
    "triangle shines like a point_light of the color e with the attenuation 1 0 0, to both sides but not onto itself, "
    "and what arrives is the mean over -shadow_samples of its points. So a lamp is as strong whatever its size and "
    "distance. Each tri and each triangle of a mesh is a lamp: a mesh that is cut into twice as many triangles gives "
    "twice the light, unless -emissive_meshes whole makes one lamp of a mesh. A quad or polygon is one lamp, however "
    "many triangles it is cut into. Spheres, boxes and other "
    "shapes are seen to glow but light nothing, unless -emissive_solids on makes lamps of all but planes.\n"
    "Mode path reads e as a radiance. Every shape that emits is a lamp, on both sides of its surface, and its light "
    "grows with its area and falls off with the square of the distance, as real light does. A lamp of area A that "
    "faces a surface at a distance d, far against its size, lights it A / (pi d^2) times as strongly as in mode "
    "whitted. With -emission color mode path reads e as mode whitted does, so that its paths only add to that what "
    "surfaces reflect of each other; mirrors still show the lamps.\n"
    "raypro -check says where the light of lamps differs by more than a factor of two between the modes, and which "
    "meshes are as many lamps as they have triangles.\n";

constexpr const char* about_files =
    "Files that a scene names are searched in the folder of the file that names them, then in the current folder, "
    "and must lie below the top scene's folder or the current one, unless -allow_path opens another. A name such as "
    "../textures/wood.png that does not exist is also searched as textures/wood.png, with a warning.\n";

constexpr std::pair<const char*, const char*> extensions[] = {
    {"mesh id file smooth",
     "Without the word smooth a mesh is flat, as in the course, and the order of a face's corners decides which side "
     "is its front. The front of a smooth mesh is where its vertex normals point: a surface that is wound the other "
     "way, as exporters that mirror leave it, is turned around as a whole, and raypro -check counts its triangles."},
    {"mesh id file smooth degrees",
     "Normals are averaged over the triangles around each corner that differ from its own by up to that many degrees."},
    {"mesh id file materials",
     "Faces have the materials that the file gives them, and colors of its vertices; the material id is for all "
     "others."},
    {"absorb, bump, coat, flat_color, gloss, mirror, normal_map, one_sided, priority, specular_map, texture_ambient, "
     "texture_project, texture_scale, vertex_colors",
     "Properties of a material defined earlier in the same file."},
    {"priority",
     "Solids that light goes through may contain one another, touch and overlap: rays are refracted between what is on "
     "both sides of a surface, and a surface with one material on both sides is not there. So water may overlap the "
     "wall of its glass by a hair, with the higher priority given to the glass. What stands on a floor is seen as if "
     "there were a gap. This needs closed solids: spheres, boxes, cylinders, cones, paraboloids, tori, and meshes "
     "whose triangles bound a volume."},
    {"one_sided",
     "The front is the side from which a face's corners are counter-clockwise, the outside of a solid, where a plane's "
     "or disc's normal points. Rays from the eye and from lit surfaces pass through a surface that they would hit from "
     "behind: it casts a shadow only towards points that see its front, and a lamp shines forward. Glass needs both "
     "sides, and keeps them with -one_sided. Large meshes are slower than with two sides."},
    {"mirror", "The weight of the mirrored ray, instead of ks, which stays that of the highlights."},
    {"coat",
     "Reflects Schlick's share for the index ir, in addition to ks, and leaves the rest to the diffuse layer below; "
     "highlights are unchanged."},
    {"gloss",
     "As -glossy for one material and with an exponent of its own, n staying that of highlights. Rays that share a "
     "reflection each have their share of its weight, which -min_luminance may cut at the next bounce."},
    {"normal_map", "Needs no vertex normals or tangents: how texture coordinates run over a shape is found from them."},
    {"specular_map",
     "Read, blended, repeated and with -srgb decoded as the texture is. It multiplies ks and what mirror says, each by "
     "its own channel, so that black mirrors nothing and has no highlight; in mode path the weight of the glossy lobe. "
     "What coat, -fresnel and -internal_reflection mirror, kt and kd stay as they are."},
    {"texture_project",
     "Without it all texture coordinates of a polygon, and of a mesh whose file has none, are 0, as in the course: it "
     "has one color. With it they are those of the place itself, in the frame of the shape, so that an image is one "
     "unit wide and high and continues from polygon to polygon; texture_scale sets the number per unit. They "
     "depend on where the front of a triangle, or of a polygon as a whole, faces most: u v is z y towards -x, -z y "
     "towards +x, x z "
     "towards -y, x -z towards +y, -x y towards -z and x y towards +z. So images are nowhere mirrored, and upright on "
     "what faces sideways. Other shapes keep the coordinates they have."},
    {"flat_color, texture_ambient",
     "The color in mode flat, if it is not kd + ks + kt; a texture that also colors ambient light."},
    {"csg",
     "Combines the solids, closed meshes, groups and further csg up to its end. A union contains the points in any of "
     "them, an intersection those in all, a difference those in the first and in none of the others. Faces may "
     "lie in each other exactly; those that differ by rounding alone are one. Each solid shows its own material, also "
     "on the wall of the hole that it leaves; what fills all of it, by ir, absorb and priority, is the material of "
     "csg. Nothing of it may emit, move by itself or have colors of vertices."},
    {"implicit",
     "The formula is written in quotes and may use x, y, z, pi, numbers, + - * /, brackets, ^ with whole "
     "exponents up to 64, sin, cos, tan, exp, log, sqrt, abs, min and max; 3 x is 3 * x. The solid is where it is 0 or "
     "below, within the "
     "box, whose faces close it. Interval arithmetic finds the nearest surface for certain. Images lie as if laid "
     "through the box along z, u and v being the shares of it along x and y; on a blob likewise."},
    {"plane",
     "Infinite, so it has no bounding box: accelerators skip it, and every ray is tested against it separately."},
    {"view",
     "Before or behind the camera. An image with another aspect shows the same part of the scene, squeezed; a shift "
     "of 1 0 moves the axis to the left edge."},
    {"shadow_bias",
     "What secondary rays hit is at least this far away. 0, the default, needs no care: they start outside the error "
     "of the hit they leave. A greater one gives the images of programs that need it."},
    {"set",
     "Sets an option that affects the image, by its name without the dash, such as max_depth 2; presets and "
     "the command line override it, and -explain shows the origin of each setting."},
    {"set srgb", "Stands before the first image that is read, whose colors it decodes."},
    {"motion", "Between begin and end."},
    {"environment", "A latitude-longitude image, an angular probe or a cross; -env takes its place."},
    {"sphere_light", "A lamp with a size, not itself seen; from afar a point_light of that color."},
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
         Roff("Each is reported with file, line and column; raypro -check looks for them without rendering.\n") +
         ".SH EXAMPLE\n.nf\n" + Roff(example) + ".fi\n.SH SEE ALSO\n.BR raypro (1),\n.BR rayview (1)\n";
}

}  // namespace ray
