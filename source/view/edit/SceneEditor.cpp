#include "source/view/edit/SceneEditor.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "source/inspect/SceneLines.h"
#include "source/parse/Files.h"
#include "source/text/Number.h"
#include "source/text/NumberText.h"
#include "source/view/commands/Commands.h"
#include "source/view/edit/SceneFiles.h"

namespace ray {
namespace {

constexpr double slow = 0.15;  // seconds of reading a scene from which on an object moves only when its drag ends
constexpr Rgba axis_color{255, 200, 60, 255};

std::string Count(std::size_t count, const char* one, const char* more) {
  return std::to_string(count) + " " + (count == 1 ? one : more);
}

/// Returns the node that has a location; std::nullopt if none has.
std::optional<std::size_t> NodeAt(const World& world, const Location& location) {
  const auto& nodes = world.Nodes();
  const auto found = std::ranges::find_if(nodes, [&](const FlatNode& flat) {
    const Location& at = flat.node->location;
    return at.line == location.line && at.column == location.column && at.file == location.file;
  });
  if (found == nodes.end() || location.line == 0) return {};
  return static_cast<std::size_t>(found - nodes.begin());
}

bool HasPoints(const ScnPlaces& places, std::uint32_t statement) {
  return std::ranges::any_of(FieldsOf(places, statement),
                             [](const ScnField& field) { return field.kind == ScnField::Kind::point; });
}

/// 1, 2 or 5 times a power of ten, the greatest that is not above `x`.
double RoundBelow(double x) {
  constexpr double least = 1e-300, most = 1e300;
  if (!(x > 0) || !std::isfinite(x)) return 1;
  double power = 1;  // exact where it is a whole number, and otherwise rounded to digits below
  while (power > x && power > least) power /= 10;
  while (10 * power <= x && power < most) power *= 10;
  for (const double factor : {5.0, 2.0})
    if (factor * power <= x) return Decimal(factor * power);
  return Decimal(power);
}

R3::Vector Snapped(const R3::Vector& way, double step) {
  const auto snap = [&](double x) { return Decimal(std::round(x / step) * step); };
  return {snap(way.x), snap(way.y), snap(way.z)};
}

/// Returns the point on the line through `from` along `axis` that is nearest to a ray, in lengths of `axis`; none along
/// the line.
///   source   Schneider, Eberly, Geometric Tools for Computer Graphics (2003), 10.8
std::optional<double> NearestOnLine(const R3::Point& from, const R3::Vector& axis, const R3::Ray& ray) {
  const R3::Vector between = from - ray.origin;
  const double aa = Dot(axis, axis), ad = Dot(axis, ray.direction), dd = Dot(ray.direction, ray.direction);
  const double determinant = aa * dd - ad * ad;
  constexpr double least_sine = 0.02;  // nearer to the axis the point runs off to the horizon
  if (!(determinant > least_sine * least_sine * aa * dd)) return {};
  return (ad * Dot(ray.direction, between) - dd * Dot(axis, between)) / determinant;
}

/// Returns the point in which a ray crosses the plane through `from`, if it does.
std::optional<R3::Point> OnPlane(const R3::Point& from, const R3::Vector& normal, const R3::Ray& ray) {
  const double t = Dot(from - ray.origin, normal) / Dot(ray.direction, normal);
  if (!(t > 0) || !std::isfinite(t)) return {};
  return ray.At(t);
}

constexpr std::array axis_names{"x", "y", "z", "the plane that faces the camera"};

/// The distance of a point along the viewing direction.
std::string FocusText(const Camera& camera, const R3::Point& point) {
  constexpr int digits = 5;
  return Rounded(Dot(point - camera.eye, camera.towards), digits);
}

std::string TextOf(const std::vector<double>& values) {
  std::string words;
  for (const double value : values) words += " " + ToText(value);
  return words;
}

}  // namespace

const ScnPlaces& SceneEditor::Places() const { return viewer_.scene.Loaded().places; }

std::string SceneEditor::WhyNot() const {
  if (!Places().files.empty()) return {};
  return "only .scn scenes can be edited; raypro SCENE -convert out.scn writes one";
}

std::string SceneEditor::Describe() const {
  if (history_.Done() == 0 && history_.Undone() == 0) return is_unsaved_ ? "not saved" : "none";
  return Count(history_.Done(), "change", "changes") +
         (history_.Undone() > 0 ? ", " + std::to_string(history_.Undone()) + " undone" : "") +
         (is_unsaved_ ? ", not saved" : ", saved");
}

void SceneEditor::Forget() {
  history_.Forget();
  texts_.reset(), copied_.reset();
  saved_.clear();
  light_.reset(), material_.reset(), drag_.reset();
  held_ = nullptr, held_is_due_ = false;
  is_unsaved_ = false;
}

bool SceneEditor::MayLose(const std::string& next) {
  const bool is_copied = copied_ && texts_ && *copied_ == *texts_;
  return (!is_unsaved_ && !viewer_.reader.IsReadingEdit()) || is_copied ||
         viewer_.notices.Confirms("the scene has unsaved changes; Control+S saves them, again to " + next + " without");
}

void SceneEditor::CheckUnsaved() { is_unsaved_ = texts_ && *texts_ != saved_; }

std::optional<std::size_t> SceneEditor::ChosenLight() const {
  if (viewer_.selection.node || !light_ || *light_ >= viewer_.scene.Parsed().lights.size()) return {};
  return light_;
}

void SceneEditor::ChooseLight(std::size_t light) {
  ChooseNode(viewer_, {});
  light_ = light;
}

std::optional<std::uint32_t> SceneEditor::ChosenStatement() const {
  const ScnPlaces& places = Places();
  if (const auto node = viewer_.selection.node)
    return StatementAt(places, viewer_.scene.world().Nodes()[*node].node->location);
  const auto light = ChosenLight();
  if (!light || *light >= places.lights.size()) return {};
  return places.lights[*light];
}

std::optional<std::size_t> SceneEditor::ChosenMaterial() const {
  const std::vector<Material>& materials = viewer_.scene.Parsed().materials;
  if (material_ && node_of_material_ == viewer_.selection.node && *material_ < materials.size()) return material_;
  if (!viewer_.selection.node) return {};
  const World& world = viewer_.scene.world();
  const std::int32_t instance = world.Nodes()[*viewer_.selection.node].instance;
  if (instance < 0) return {};
  const Material* const used = world.Instances()[static_cast<std::size_t>(instance)].material;
  const auto found = std::ranges::find_if(materials, [&](const Material& m) { return &m == used; });
  if (found == materials.end()) return {};
  return static_cast<std::size_t>(found - materials.begin());
}

void SceneEditor::ChooseMaterial(std::size_t material) {
  material_ = material;
  node_of_material_ = viewer_.selection.node;
}

std::string SceneEditor::Name(std::uint32_t statement) const { return NameOf(Places(), statement); }

std::optional<EditPlace> SceneEditor::PlaceOf(std::optional<std::uint32_t> statement) const {
  const ScnPlaces& places = Places();
  if (!statement || *statement >= places.statements.size()) return {};
  const ScnPlaces::Statement& at = places.statements[*statement];
  return EditPlace{places.files[at.file].canonical, at.begin};
}

void SceneEditor::Choose(const EditPlace& place) {
  const ScnPlaces& places = Places();
  const auto file = std::ranges::find(places.files, place.file, &ScnPlaces::File::canonical);
  if (file == places.files.end()) return;
  const auto index = static_cast<std::uint32_t>(file - places.files.begin());
  const auto statement = StatementAt(places, index, place.begin);
  if (!statement) return;
  if (const auto light = std::ranges::find(places.lights, *statement); light != places.lights.end())
    return ChooseLight(static_cast<std::size_t>(light - places.lights.begin()));
  ChooseNode(viewer_, NodeAt(viewer_.scene.world(), LocationAt(places, index, place.begin)));
}

void SceneEditor::RefuseReadOnly(const TextEdits& edits) const {
  const ScnPlaces& places = Places();
  for (const TextEdit& edit : edits) {
    const bool is_top = edit.file == places.files.front().canonical;  // of which a copy can be saved
    if (!is_top && access(edit.file.c_str(), W_OK) != 0)
      throw EditRefusal("the included file " + edit.file + " cannot be written");
  }
}

void SceneEditor::Do(const std::string& what, const std::string& key, bool continues,
                     const std::function<TextEdits()>& make, const std::optional<EditPlace>& chosen_after) {
  if (const std::string why = WhyNot(); !why.empty()) return viewer_.notices.Show(why);
  if (MustWait()) return;
  TextEdits edits;
  try {
    edits = make();
    RefuseReadOnly(edits);
  } catch (const EditRefusal& refusal) {
    return viewer_.notices.Show("cannot " + what + ": " + refusal.what());
  }
  if (edits.empty()) return;  // it is so already
  const auto before = PlaceOf(ChosenStatement());
  auto after = chosen_after;
  if (!after && before) after = EditPlace{before->file, OffsetAfter(edits, before->file, before->begin)};
  Apply(edits, after, [=, this] {
    history_.Do({what, key, edits, before, after}, continues);
    return what;
  });
}

bool SceneEditor::MustWait() {
  if (!viewer_.reader.IsBusy()) return false;
  viewer_.notices.Show("wait: " + viewer_.reader.Describe());
  return true;
}

void SceneEditor::Apply(const TextEdits& edits, const std::optional<EditPlace>& chosen,
                        const std::function<std::string()>& then) {
  if (!texts_) {
    saved_.clear();
    for (const ScnPlaces::File& file : Places().files) saved_[file.canonical] = file.text->bytes;
  }
  const auto next = std::make_shared<const EditedFiles>(Edited(texts_ ? *texts_ : saved_, edits));
  const bool had_material = material_ && node_of_material_ == viewer_.selection.node;
  held_ = nullptr;  // it was of the text before
  ShowEdits(viewer_, next, [=, this](const std::string& problem) {
    if (!problem.empty()) return viewer_.notices.Show("refused: " + problem);
    texts_ = next;
    light_.reset();
    if (chosen) Choose(*chosen);
    if (had_material) node_of_material_ = viewer_.selection.node;
    const std::string done = then();
    CheckUnsaved();
    viewer_.notices.Show(done);
  });
}

bool SceneEditor::IsSlow() const { return viewer_.reader.IsBusy() || viewer_.reader.Seconds() > slow; }

void SceneEditor::SetField(std::uint32_t statement, const ScnField& field, const std::vector<double>& values,
                           bool continues) {
  const auto place = PlaceOf(statement);
  const std::string key = place ? field.name + "@" + std::to_string(place->begin) + place->file : "";
  const std::string what = "set " + field.name + " of " + Name(statement) + " to" + TextOf(values);
  DoOrHold(what, key, continues, [=, this] {
    if (PlaceOf(statement) != place) throw EditRefusal("the scene has changed meanwhile");
    return WithValues(Places(), statement, field, values);
  });
}

void SceneEditor::DoOrHold(const std::string& what, const std::string& key, bool continues,
                           const std::function<TextEdits()>& make) {
  const auto change = [=, this] { Do(what, key, continues, make); };
  if (!continues || !IsSlow()) return change();
  held_ = change;
  viewer_.notices.Show(what + ", once the button is let go");
}

void SceneEditor::DoHeld() {
  held_is_due_ = held_ && viewer_.reader.IsBusy();
  if (held_is_due_) return;
  if (const auto held = std::exchange(held_, nullptr)) held();
}

void SceneEditor::DoDue() {
  if (held_is_due_) DoHeld();
}

void SceneEditor::SetSetting(const std::string& option, const std::string& value, bool continues) {
  std::vector<std::pair<std::string, std::string>> settings{{option, value}};
  // An open lens needs a distance to focus on.
  const bool needs_focus = option == "aperture" && value != "0" && !(viewer_.SettingsOfView().camera.focus > 0);
  if (needs_focus) settings.emplace_back("focus", FocusText(viewer_.navigator.camera(), viewer_.navigator.Center()));
  DoOrHold("set " + option + " " + value, option, continues, [=, this] { return WithSettings(Places(), settings); });
}

void SceneEditor::AddToMaterial(std::size_t material, const std::string& command) {
  const R2::Color& kr = viewer_.scene.Parsed().materials[material].kr;
  const std::string numbers =
      command == "mirror" ? ToText(kr.r) + " " + ToText(kr.g) + " " + ToText(kr.b) : std::string("1000 4");
  Do("add " + command + " to " + Name(Places().materials[material]), "", false,
     [&] { return WithAboutMaterial(Places(), material, command, numbers); });
}

void SceneEditor::SetTexture(std::size_t material, const std::string& name) {
  Do(name.empty() ? "take the texture away" : "set the texture to " + name, "", false,
     [&] { return WithTexture(Places(), material, name); });
}

void SceneEditor::SetAxis(MoveAxis axis) {
  axis_ = axis;
  viewer_.notices.Show(std::string("= and - move along ") + axis_names[static_cast<std::size_t>(axis_)] + ", by " +
                       ToText(Step()) + "; so does a drag with Control and Shift");
}

void SceneEditor::NextAxis() {
  SetAxis(static_cast<MoveAxis>((static_cast<std::size_t>(axis_) + 1) % axis_names.size()));
}

double SceneEditor::Step() const {
  constexpr double share_of_radius = 0.05;
  return RoundBelow(share_of_radius * viewer_.navigator.box().Radius());
}

R3::Vector SceneEditor::AxisVector() const {
  if (axis_ == MoveAxis::view) return viewer_.navigator.camera().right;
  const auto along = [&](MoveAxis axis) { return axis_ == axis ? 1.0 : 0.0; };
  return {along(MoveAxis::x), along(MoveAxis::y), along(MoveAxis::z)};
}

std::optional<SceneEditor::Target> SceneEditor::TargetOf() const {
  const ScnPlaces& places = Places();
  const auto statement = ChosenStatement();
  if (!statement) return {};
  const World& world = viewer_.scene.world();
  if (const auto light = ChosenLight()) {
    const LightBound bound = viewer_.scene.Parsed().lights[*light]->Bound();
    Target target{*statement, 0, {}};
    if (!bound.is_infinite) target.box = {bound.center, bound.center};
    return target;
  }
  std::size_t node = *viewer_.selection.node;
  Target target{*statement, FrameAround(world, node), {}};
  target.box = world.InWorld(target.frame, world.Nodes()[node].node->bounds);
  // What says no place of its own is moved with the group that is around it alone.
  const std::size_t parent = ParentsOf(world)[node];
  if (HasPoints(places, *statement) || parent == world.Nodes().size() || world.Nodes()[parent].children != 1)
    return target;
  const auto group = StatementAt(places, world.Nodes()[parent].node->location);
  if (!group || CommandOf(places, *group) != "begin") return target;
  target.statement = *group;
  target.frame = FrameAround(world, parent);
  return target;
}

std::optional<SceneEditor::Target> SceneEditor::ChosenTarget() const {
  if (const std::string why = WhyNot(); !why.empty())
    viewer_.notices.Show(why);
  else if (!viewer_.selection.node && !ChosenLight())
    viewer_.notices.Show("nothing is chosen; click an object first");
  else if (const auto target = TargetOf())
    return target;
  else
    viewer_.notices.Show("what is chosen stands in no scene file");
  return {};
}

void SceneEditor::Move(const R3::Vector& way, const std::string& key, bool continues) {
  const auto target = ChosenTarget();
  if (!target) return;
  const R3::Vector local = viewer_.scene.world().Frames()[target->frame].Inverse() * way;
  Do("move " + Name(target->statement), key, continues, [&] { return Moved(Places(), target->statement, local); });
}

void SceneEditor::MoveBySteps(double steps) { Move(steps * Step() * AxisVector(), "", false); }

void SceneEditor::Delete() {
  const auto target = ChosenTarget();
  if (!target) return;
  Do(
      "delete " + Name(target->statement), "", false, [&] { return Removed(Places(), target->statement); },
      EditPlace{});
}

void SceneEditor::Duplicate() {
  const auto target = ChosenTarget();
  if (!target) return;
  const double width = target->box.IsEmpty() ? 0 : target->box.Size().x;
  const double step = Step(), gap = std::isfinite(width) ? std::ceil(width / step + 1) * step : step;
  const bool is_placed = !target->box.IsEmpty() || viewer_.selection.node;
  const R3::Vector way = is_placed ? R3::Vector{Decimal(gap), 0, 0} : R3::Vector{};
  const R3::Vector local = viewer_.scene.world().Frames()[target->frame].Inverse() * way;
  Copied copied;
  try {
    copied = Duplicated(Places(), target->statement, local);
  } catch (const EditRefusal& refusal) {
    return viewer_.notices.Show(std::string("cannot duplicate it: ") + refusal.what());
  }
  const auto place = PlaceOf(target->statement);
  Do(
      "duplicate " + Name(target->statement), "", false, [&] { return copied.edits; },
      EditPlace{place->file, copied.begin});
}

void SceneEditor::KeepCamera() {
  if (!viewer_.HasMovedCamera() && LastOf(Places(), "camera"))
    return viewer_.notices.Show("the view is the scene's camera already");
  Do("the view becomes the scene's camera", "", false,
     [&] { return WithCamera(Places(), viewer_.navigator.camera()); });
}

void SceneEditor::FocusOn(const std::optional<R3::Point>& point) {
  if (!point) return viewer_.notices.Show("nothing is under the pointer to focus on");
  const std::string focus = FocusText(viewer_.navigator.camera(), *point);
  const bool has_lens = viewer_.SettingsOfView().camera.HasLens();
  constexpr double opening = 0.01;  // of the distance, where no lens was open
  const std::string aperture = ToText(RoundBelow(opening * ParseNumber(focus).value));
  std::vector<std::pair<std::string, std::string>> settings{{"focus", focus}};
  if (!has_lens) settings.emplace_back("aperture", aperture);
  Do("focus at " + focus + (has_lens ? "" : ", aperture " + aperture), "", false,
     [&] { return WithSettings(Places(), settings); });
}

bool SceneEditor::BeginDrag(const R3::Ray& ray) {
  const auto target = ChosenTarget();
  if (!target) return false;
  if (target->box.IsEmpty()) {
    viewer_.notices.Show("it is infinite, empty or far away; = and - move it along the axis");
    return false;
  }
  drag_ = Drag{target->box.Center(), ray, {}, {}};
  return true;
}

void SceneEditor::DragTo(const R3::Ray& ray) {
  if (!drag_) return;
  R3::Vector way;
  if (axis_ == MoveAxis::view) {
    const R3::Vector& normal = viewer_.navigator.camera().towards;
    const auto from = OnPlane(drag_->from, normal, drag_->pressed), to = OnPlane(drag_->from, normal, ray);
    if (!from || !to) return;
    way = *to - *from;
  } else {
    const R3::Vector axis = AxisVector();
    const auto from = NearestOnLine(drag_->from, axis, drag_->pressed), to = NearestOnLine(drag_->from, axis, ray);
    if (!from || !to) return;
    way = (*to - *from) * axis;
  }
  constexpr double share_of_step = 0.1;
  drag_->left = Snapped(way, share_of_step * Step()) - drag_->done;
  if (IsSlow()) return;
  const Drag now = *drag_;
  if (now.left == R3::Vector{}) return;
  drag_->done = now.done + now.left, drag_->left = {};
  Move(now.left, "drag", !(now.done == R3::Vector{}));
}

void SceneEditor::EndDrag() {
  if (!drag_) return;
  const Drag last = *std::exchange(drag_, {});
  if (last.left == R3::Vector{}) return;
  held_ = [=, this] { Move(last.left, "drag", !(last.done == R3::Vector{})); };
  DoHeld();
}

void SceneEditor::Undo() {
  const Change* change = history_.ToUndo();
  if (!change) return viewer_.notices.Show("nothing to undo");
  if (MustWait()) return;
  const auto now = PlaceOf(ChosenStatement());
  const TextEdits edits = Reversed(change->edits);
  auto chosen = change->chosen_before;
  if (!chosen && now) chosen = EditPlace{now->file, OffsetAfter(edits, now->file, now->begin)};
  const std::string what = change->what;
  Apply(edits, chosen, [=, this] {
    history_.Undo();
    return "undone: " + what;
  });
}

void SceneEditor::Redo() {
  const Change* change = history_.ToRedo();
  if (!change) return viewer_.notices.Show("nothing to redo");
  if (MustWait()) return;
  const std::string what = change->what;
  Apply(change->edits, change->chosen_after, [=, this] {
    history_.Redo();
    return "redone: " + what;
  });
}

void SceneEditor::Save() {
  if (const std::string why = WhyNot(); !why.empty()) return viewer_.notices.Show(why);
  if (MustWait()) return;
  if (!is_unsaved_) return viewer_.notices.Show("there is nothing to save");
  std::string saved, replaced;
  std::vector<const ScnPlaces::File*> changed;
  for (const ScnPlaces::File& file : Places().files) {
    if (texts_->at(file.canonical) == saved_[file.canonical]) continue;
    changed.push_back(&file);
    const std::string& name = file.text->name;
    if (file.canonical == standard_input_name)
      return viewer_.notices.Show("the scene came from standard input; Control+Shift+S saves a copy");
    if (ReadSceneFile(name) != saved_[file.canonical]) replaced += (replaced.empty() ? "" : ", ") + name;
  }
  if (!replaced.empty() &&
      !viewer_.notices.Confirms(replaced + " changed on the disk since it was read; Control+S again replaces it"))
    return;
  for (const ScnPlaces::File* file_of : changed) {
    const ScnPlaces::File& file = *file_of;
    const std::string& text = texts_->at(file.canonical);
    const std::string& name = file.text->name;
    if (const std::string problem = SaveScene(viewer_, name, text); !problem.empty())
      return viewer_.notices.Show(problem);
    saved_[file.canonical] = text;
    saved += (saved.empty() ? "" : ", ") + name;
  }
  CheckUnsaved();
  viewer_.notices.Show("saved " + saved);
}

void SceneEditor::SaveCopy() {
  if (const std::string why = WhyNot(); !why.empty()) return viewer_.notices.Show(why);
  if (MustWait()) return;
  const auto& files = Places().files;
  const ScnPlaces::File& top = files.front();
  for (const ScnPlaces::File& file : files)
    if (texts_ && &file != &top && texts_->at(file.canonical) != saved_[file.canonical])
      return viewer_.notices.Show("a copy has no room for the changes of the included " + file.text->name +
                                  "; Control+S saves all");
  const std::string name = FreeCopyName(top.canonical == standard_input_name ? "scene.scn" : top.text->name);
  const std::string& text = texts_ ? texts_->at(top.canonical) : top.text->bytes;
  if (const std::string problem = SaveScene(viewer_, name, text); !problem.empty())
    return viewer_.notices.Show(problem);
  copied_ = texts_;
  viewer_.notices.Show("a copy is saved as " + name);
}

Lines SceneEditor::Marks(const DrawingSpace& space, const std::function<double(const R3::Point&)>& size_at) const {
  Lines lines;
  if (!WhyNot().empty()) return lines;
  const auto target = TargetOf();
  if (!target || target->box.IsEmpty()) return lines;
  const R3::Point at = target->box.Center();
  constexpr double times_of_cross = 6, times_of_box = 1.3;  // so that it extends beyond the object
  const double size = std::max(times_of_cross * size_at(at), times_of_box * target->box.Radius());
  const auto arrows = [&](const R3::Vector& way) {
    Append(lines, ArrowAt(at, size * way, space, axis_color));
    Append(lines, ArrowAt(at, -size * way, space, axis_color));
  };
  arrows(AxisVector());
  if (axis_ == MoveAxis::view) arrows(viewer_.navigator.camera().up);
  return lines;
}

}  // namespace ray
