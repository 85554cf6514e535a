#include "source/view/gl/Program.h"

#include <algorithm>
#include <array>
#include <string>

namespace ray {

namespace {

/// A shader that is needed only until the program is linked.
class Shader {
 public:
  Shader(const Functions& gl, GLenum type, const char* text) : gl_(gl), shader_(gl.CreateShader(type)) {
    gl.ShaderSource(shader_, 1, &text, nullptr);
    gl.CompileShader(shader_);
  }
  ~Shader() { gl_.DeleteShader(shader_); }
  Shader(const Shader&) = delete;
  Shader& operator=(const Shader&) = delete;

  GLuint Name() const { return shader_; }
  bool IsCompiled() const {
    GLint status = 0;
    gl_.GetShaderiv(shader_, GL_COMPILE_STATUS, &status);
    return status != 0;
  }

 private:
  const Functions& gl_;
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

Program::Program(std::shared_ptr<const Functions> gl, const char* name, const char* vertex_shader,
                 const char* fragment_shader)
    : gl_(std::move(gl)) {
  const Shader vertex(*gl_, GL_VERTEX_SHADER, vertex_shader), fragment(*gl_, GL_FRAGMENT_SHADER, fragment_shader);
  for (const Shader* shader : {&vertex, &fragment})
    if (!shader->IsCompiled())
      throw ContextError(std::string("OpenGL refuses the shader that draws ") + name + ": " +
                         FirstLine(gl_->GetShaderInfoLog, shader->Name()));
  program_ = gl_->CreateProgram();
  gl_->AttachShader(program_, vertex.Name());
  gl_->AttachShader(program_, fragment.Name());
  gl_->LinkProgram(program_);
  GLint status = 0;
  gl_->GetProgramiv(program_, GL_LINK_STATUS, &status);
  if (status) return;
  const std::string why = FirstLine(gl_->GetProgramInfoLog, program_);
  gl_->DeleteProgram(program_);
  throw ContextError(std::string("OpenGL refuses the program that draws ") + name + ": " + why);
}

Program::~Program() { gl_->DeleteProgram(program_); }

void SetMatrix(const Functions& gl, GLint uniform, const ClipMatrix& matrix) {
  std::array<float, 16> single{};
  std::transform(matrix.begin(), matrix.end(), single.begin(), [](double x) { return static_cast<float>(x); });
  gl.UniformMatrix4fv(uniform, 1, GL_FALSE, single.data());
}

}  // namespace ray
