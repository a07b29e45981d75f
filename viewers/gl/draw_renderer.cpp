#include "viewers/gl/draw_renderer.h"

#include <array>
#include <cstddef>
#include <string>

#include "core/image/color_map.h"
#include "viewers/gl/draw_shader.h"

namespace glint::view {
namespace {

constexpr std::size_t k_plain = 4;  // the program of plain colours, after those of Shading
constexpr std::size_t k_programs = k_plain + 1;

Result<GLuint> compile(const GlFunctions& gl, GLenum stage, const std::string& source) {
  const GLuint shader = gl.CreateShader(stage);
  const char* text = source.c_str();
  gl.ShaderSource(shader, 1, &text, nullptr);
  gl.CompileShader(shader);
  GLint compiled = 0;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  if (compiled != 0) return shader;
  std::array<char, 1024> log{};
  gl.GetShaderInfoLog(shader, log.size(), nullptr, log.data());
  gl.DeleteShader(shader);
  return content_error("OpenGL", std::string("cannot compile the window's shader: ") + log.data());
}

Texture map_texture(const GlFunctions& gl, const std::array<DisplayColor, 256>& table) {
  std::array<std::uint8_t, 1024> texels{};
  for (std::size_t k = 0; k < table.size(); ++k) {
    for (std::size_t c = 0; c < 3; ++c) texels[4 * k + c] = table[k][static_cast<int>(c)];
    texels[4 * k + 3] = 255;
  }
  return {gl, Texture::Format::rgba8, {256, 1}, texels.data()};
}

GLuint make_sampler(const GlFunctions& gl, GLint smaller, GLint larger) {
  GLuint name = 0;
  gl.GenSamplers(1, &name);
  gl.SamplerParameteri(name, GL_TEXTURE_MIN_FILTER, smaller);
  gl.SamplerParameteri(name, GL_TEXTURE_MAG_FILTER, larger);
  gl.SamplerParameteri(name, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  gl.SamplerParameteri(name, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return name;
}

// One a kind of shading, and one of plain colours.
struct Program {
  GLuint name = 0;
  GLint projection = -1;
  GLint range = -1;
};

void set_scissor(const GlFunctions& gl, const ImDrawData& data, const PixelRectangle& rectangle) {
  const auto height = static_cast<GLint>(data.DisplaySize.y);
  gl.Scissor(rectangle.x0, height - rectangle.y1, rectangle.x1 - rectangle.x0, rectangle.y1 - rectangle.y0);
}

Result<Program> build_program(const GlFunctions& gl, std::size_t kind) {
  const Result<GLuint> vertex = compile(gl, GL_VERTEX_SHADER, k_vertex_shader);
  if (!vertex) return vertex.error();
  const std::string head = "#version 330 core\n#define KIND " + std::to_string(kind) + "\n";
  const Result<GLuint> fragment = compile(gl, GL_FRAGMENT_SHADER, head + k_fragment_shader);
  if (!fragment) return fragment.error();
  Program program;
  program.name = gl.CreateProgram();
  for (const GLuint shader : {*vertex, *fragment}) {
    gl.AttachShader(program.name, shader);
    gl.DeleteShader(shader);  // lives on as part of the program
  }
  gl.LinkProgram(program.name);
  GLint linked = 0;
  gl.GetProgramiv(program.name, GL_LINK_STATUS, &linked);
  if (linked == 0) return content_error("OpenGL", "cannot link the window's shaders");
  program.projection = gl.GetUniformLocation(program.name, "projection");
  program.range = gl.GetUniformLocation(program.name, "range");
  gl.UseProgram(program.name);
  gl.Uniform1i(gl.GetUniformLocation(program.name, "values"), 0);
  gl.Uniform1i(gl.GetUniformLocation(program.name, "map"), 1);
  return program;
}

}  // namespace

struct DrawRenderer::Resources {
  std::array<Program, k_programs> programs;
  GLuint vertex_array = 0;
  GLuint vertices = 0;
  GLuint indices = 0;
  GLuint linear = 0;
  GLuint mipmapped = 0;
  GLuint nearest = 0;
  Texture viridis;
  Texture difference;
};

Result<std::unique_ptr<DrawRenderer>> DrawRenderer::create(const GlFunctions& gl) {
  std::unique_ptr<DrawRenderer> renderer(new DrawRenderer(gl));
  if (const Status built = renderer->build(); !built) return built.error();
  return renderer;
}

DrawRenderer::DrawRenderer(const GlFunctions& gl) : gl_(gl), own_(std::make_unique<Resources>()) {}

DrawRenderer::~DrawRenderer() {
  for (const GLuint sampler : {own_->linear, own_->mipmapped, own_->nearest}) gl_.DeleteSamplers(1, &sampler);
  gl_.DeleteBuffers(1, &own_->vertices);
  gl_.DeleteBuffers(1, &own_->indices);
  gl_.DeleteVertexArrays(1, &own_->vertex_array);
  for (const Program& program : own_->programs) gl_.DeleteProgram(program.name);
}

Status DrawRenderer::build() {
  for (std::size_t kind = 0; kind < k_programs; ++kind) {
    const Result<Program> program = build_program(gl_, kind);
    if (!program) return program.error();
    own_->programs[kind] = *program;
  }
  own_->linear = make_sampler(gl_, GL_LINEAR, GL_LINEAR);
  own_->mipmapped = make_sampler(gl_, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
  own_->nearest = make_sampler(gl_, GL_NEAREST, GL_NEAREST);
  own_->viridis = map_texture(gl_, viridis_table());
  own_->difference = map_texture(gl_, difference_table());

  gl_.GenVertexArrays(1, &own_->vertex_array);
  gl_.GenBuffers(1, &own_->vertices);
  gl_.GenBuffers(1, &own_->indices);
  gl_.BindVertexArray(own_->vertex_array);
  gl_.BindBuffer(GL_ARRAY_BUFFER, own_->vertices);
  gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, own_->indices);
  const auto attribute = [&](GLuint index, GLint size, GLenum type, GLboolean normalised, std::size_t offset) {
    gl_.EnableVertexAttribArray(index);
    gl_.VertexAttribPointer(index, size, type, normalised, sizeof(ImDrawVert),
                            reinterpret_cast<const void*>(offset));  // NOLINT(performance-no-int-to-ptr): GL's offset
  };
  attribute(0, 2, GL_FLOAT, GL_FALSE, offsetof(ImDrawVert, pos));
  attribute(1, 2, GL_FLOAT, GL_FALSE, offsetof(ImDrawVert, uv));
  attribute(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(ImDrawVert, col));
  return success();
}

void DrawRenderer::upload_fonts() {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  unsigned char* pixels = nullptr;
  glm::ivec2 size;
  atlas.GetTexDataAsAlpha8(&pixels, &size.x, &size.y);
  font_ = Texture(gl_, Texture::Format::coverage, size, pixels);
  font_picture_ = {&font_, {.kind = Shading::Kind::coverage}};
  atlas.SetTexID(&font_picture_);
}

void DrawRenderer::set_state(const ImDrawData& data) {
  gl_.Enable(GL_BLEND);
  gl_.BlendEquation(GL_FUNC_ADD);
  gl_.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  gl_.Disable(GL_CULL_FACE);
  gl_.Disable(GL_DEPTH_TEST);
  gl_.Enable(GL_SCISSOR_TEST);
  gl_.BindVertexArray(own_->vertex_array);
  gl_.BindBuffer(GL_ARRAY_BUFFER, own_->vertices);
  gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, own_->indices);
  gl_.BindSampler(1, own_->linear);
  const float left = data.DisplayPos.x;
  const float top = data.DisplayPos.y;
  const float width = data.DisplaySize.x;
  const float height = data.DisplaySize.y;
  const std::array<float, 16> projection = {
      2 / width, 0, 0, 0, 0, -2 / height, 0, 0, 0, 0, -1, 0, -1 - 2 * left / width, 1 + 2 * top / height, 0, 1};
  for (const Program& program : own_->programs) {
    gl_.UseProgram(program.name);
    gl_.UniformMatrix4fv(program.projection, 1, GL_FALSE, projection.data());
  }
}

void DrawRenderer::set_picture(const FramePicture& picture) {
  const Shading& shading = picture.shading;
  gl_.ActiveTexture(GL_TEXTURE1);
  const Texture& map = shading.kind == Shading::Kind::difference ? own_->difference : own_->viridis;
  gl_.BindTexture(GL_TEXTURE_2D, map.name());
  gl_.ActiveTexture(GL_TEXTURE0);
  gl_.BindTexture(GL_TEXTURE_2D, picture.texture->name());
  const bool has_levels = picture.texture->format() == Texture::Format::value;
  gl_.BindSampler(0, shading.nearest ? own_->nearest : has_levels ? own_->mipmapped : own_->linear);
  const Program& program = own_->programs[static_cast<std::size_t>(shading.kind)];
  gl_.UseProgram(program.name);
  if (program.range >= 0) gl_.Uniform4f(program.range, shading.lo, shading.hi, shading.logarithmic ? 1.0F : 0.0F, 0.0F);
}

void DrawRenderer::set_fill(const PlannedDraw& draw) {
  if (draw.fill == PlannedDraw::Fill::picture) {
    gl_.Enable(GL_BLEND);
    set_picture(*draw.picture);
    return;
  }
  if (draw.fill == PlannedDraw::Fill::plain) {
    gl_.Enable(GL_BLEND);
  } else {
    gl_.Disable(GL_BLEND);
  }
  gl_.UseProgram(own_->programs[k_plain].name);
}

void DrawRenderer::clear(const ImDrawData& data, std::span<const PixelRectangle> rectangles, ImVec4 background) {
  gl_.ClearColor(background.x, background.y, background.z, 1);
  for (const PixelRectangle& rectangle : rectangles) {
    set_scissor(gl_, data, rectangle);
    gl_.Clear(GL_COLOR_BUFFER_BIT);
  }
}

void DrawRenderer::draw(const ImDrawData& data, std::span<const PixelRectangle> rectangles, ImVec4 background) {
  if (rectangles.empty()) return;
  gl_.Viewport(0, 0, static_cast<GLsizei>(data.DisplaySize.x), static_cast<GLsizei>(data.DisplaySize.y));
  set_state(data);
  clear(data, rectangles, background);
  const DrawPlan plan = plan_drawing(data, rectangles);
  gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(plan.indices.size() * sizeof(ImDrawIdx)),
                 plan.indices.data(), GL_STREAM_DRAW);
  int uploaded = -1;
  for (const PlannedDraw& draw : plan.draws) {
    if (draw.list != uploaded) {
      const ImVector<ImDrawVert>& vertices = data.CmdLists[draw.list]->VtxBuffer;
      gl_.BufferData(GL_ARRAY_BUFFER, vertices.size_in_bytes(), vertices.Data, GL_STREAM_DRAW);
      uploaded = draw.list;
    }
    set_scissor(gl_, data, draw.scissor);
    set_fill(draw);
    gl_.DrawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(draw.index_count), GL_UNSIGNED_SHORT,
                               reinterpret_cast<const void*>(  // NOLINT(performance-no-int-to-ptr): GL's offset
                                   draw.first_index * sizeof(ImDrawIdx)),
                               static_cast<GLint>(draw.vertex_offset));
  }
  gl_.Disable(GL_SCISSOR_TEST);
}

}  // namespace glint::view
