#include "source/draw/gl/ShaderProgram.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "source/draw/contexts/Context.h"

namespace ray {
namespace {

/// A shader that is needed only until the program is linked.
class Shader {
 public:
  Shader(GLenum type, const char* text) : shader_(glCreateShader(type)) {
    glShaderSource(shader_, 1, &text, nullptr);
    glCompileShader(shader_);
  }
  ~Shader() { glDeleteShader(shader_); }
  Shader(const Shader&) = delete;
  Shader& operator=(const Shader&) = delete;

  GLuint Name() const { return shader_; }
  bool IsCompiled() const {
    GLint status = 0;
    glGetShaderiv(shader_, GL_COMPILE_STATUS, &status);
    return status != 0;
  }

 private:
  GLuint shader_;
};

template <typename GetLog>
std::string FirstLine(GetLog get_log, GLuint object) {
  std::array<char, 1024> log{};
  get_log(object, static_cast<GLsizei>(log.size() - 1), nullptr, log.data());
  const std::string text = log.data();
  return text.substr(0, text.find('\n'));
}

}  // namespace

ShaderProgram::ShaderProgram(const char* name, const char* vertex_shader, const char* fragment_shader,
                             const char* geometry_shader) {
  const Shader vertex(GL_VERTEX_SHADER, vertex_shader), fragment(GL_FRAGMENT_SHADER, fragment_shader);
  std::optional<Shader> geometry;
  if (geometry_shader) geometry.emplace(GL_GEOMETRY_SHADER, geometry_shader);
  const std::array<const Shader*, 3> all{&vertex, &fragment, geometry ? &*geometry : nullptr};
  for (const Shader* shader : all)
    if (shader && !shader->IsCompiled())
      throw ContextError(std::string("the driver rejects the shader that draws ") + name + ": " +
                         FirstLine(glGetShaderInfoLog, shader->Name()));
  program_ = glCreateProgram();
  for (const Shader* shader : all)
    if (shader) glAttachShader(program_, shader->Name());
  glLinkProgram(program_);
  GLint status = 0;
  glGetProgramiv(program_, GL_LINK_STATUS, &status);
  if (status) return;
  const std::string why = FirstLine(glGetProgramInfoLog, program_);
  glDeleteProgram(program_);
  throw ContextError(std::string("the driver rejects the program that draws ") + name + ": " + why);
}

ShaderProgram::~ShaderProgram() { glDeleteProgram(program_); }

void SetMatrix(GLint uniform, const ClipMatrix& matrix) { SetMatrices(uniform, {&matrix, 1}); }

void SetMatrices(GLint uniform, std::span<const ClipMatrix> matrices) {
  std::vector<float> single;
  for (const ClipMatrix& matrix : matrices)
    std::transform(matrix.begin(), matrix.end(), std::back_inserter(single),
                   [](double x) { return static_cast<float>(x); });
  glUniformMatrix4fv(uniform, static_cast<GLsizei>(matrices.size()), GL_FALSE, single.data());
}

}  // namespace ray
