#include "viewer/viewer_materials.h"

#include <QByteArray>
#include <QUrl>
#include <Qt3DCore/QAttribute>
#include <Qt3DCore/QBuffer>
#include <Qt3DRender/QBlendEquation>
#include <Qt3DRender/QBlendEquationArguments>
#include <Qt3DRender/QCameraSelector>
#include <Qt3DRender/QCullFace>
#include <Qt3DRender/QDepthTest>
#include <Qt3DRender/QEffect>
#include <Qt3DRender/QFilterKey>
#include <Qt3DRender/QGraphicsApiFilter>
#include <Qt3DRender/QMultiSampleAntiAliasing>
#include <Qt3DRender/QNoDepthMask>
#include <Qt3DRender/QNoDraw>
#include <Qt3DRender/QRenderPass>
#include <Qt3DRender/QRenderPassFilter>
#include <Qt3DRender/QRenderStateSet>
#include <Qt3DRender/QShaderProgram>
#include <Qt3DRender/QSortPolicy>
#include <Qt3DRender/QTechnique>
#include <Qt3DRender/QViewport>
#include <cstring>
#include <initializer_list>

namespace limbwave::ui {

namespace {

constexpr const char* kSurfaceVertex = R"(#version 150 core
in vec3 vertexPosition;
in vec3 vertexNormal;
out vec3 world_position;
out vec3 world_normal;
uniform mat4 modelMatrix;
uniform mat3 modelNormalMatrix;
uniform mat4 mvp;
void main() {
  world_position = vec3(modelMatrix * vec4(vertexPosition, 1.0));
  world_normal = normalize(modelNormalMatrix * vertexNormal);
  gl_Position = mvp * vec4(vertexPosition, 1.0);
}
)";

// Key light over the viewer's shoulder, so that every view is lit; sky and floor fill the shades; a rim keeps the
// outline off the background.
constexpr const char* kSurfaceFragment = R"(#version 150 core
in vec3 world_position;
in vec3 world_normal;
out vec4 fragment;
uniform vec3 eyePosition;
uniform vec4 surface_color;
void main() {
  vec3 n = normalize(world_normal);
  vec3 to_eye = normalize(eyePosition - world_position);
  vec3 side = normalize(cross(vec3(0.0, 0.0, 1.0), to_eye) + vec3(1e-5, 0.0, 0.0));
  vec3 key = normalize(0.75 * to_eye - 0.55 * side + vec3(0.0, 0.0, 0.75));
  float lit = max(dot(n, key), 0.0);
  float sky = 0.5 + 0.5 * n.z;
  float rim = pow(1.0 - abs(dot(n, to_eye)), 3.0);
  float gloss = pow(max(dot(n, normalize(key + to_eye)), 0.0), 40.0);
  vec3 ambient = mix(vec3(0.26, 0.27, 0.31), vec3(0.44, 0.46, 0.50), sky);
  vec3 color = surface_color.rgb * (ambient + 0.62 * lit) + vec3(0.10) * gloss + 0.10 * rim * surface_color.rgb;
  fragment = vec4(color, surface_color.a);
}
)";

constexpr const char* kFlatFragment = R"(#version 150 core
in vec3 world_position;
in vec3 world_normal;
out vec4 fragment;
uniform vec4 surface_color;
void main() { fragment = surface_color; }
)";

// The shadow falls straight down: it says where over the floor a bone is.
constexpr const char* kShadowVertex = R"(#version 150 core
in vec3 vertexPosition;
uniform mat4 modelMatrix;
uniform mat4 viewProjectionMatrix;
void main() {
  vec4 world = modelMatrix * vec4(vertexPosition, 1.0);
  gl_Position = viewProjectionMatrix * vec4(world.xy, 0.0, 1.0);
}
)";
constexpr const char* kShadowFragment = R"(#version 150 core
out vec4 fragment;
uniform vec4 shadow_color;
void main() { fragment = shadow_color; }
)";

constexpr const char* kFloorVertex = R"(#version 150 core
in vec3 vertexPosition;
out vec2 floor_position;
out vec2 from_middle;
uniform mat4 modelMatrix;
uniform mat4 mvp;
void main() {
  floor_position = (modelMatrix * vec4(vertexPosition, 1.0)).xy;
  from_middle = vertexPosition.xy;
  gl_Position = mvp * vec4(vertexPosition, 1.0);
}
)";

// Lines one pixel wide at every distance; the fine ones go where they would merge.
constexpr const char* kFloorFragment = R"(#version 150 core
in vec2 floor_position;
in vec2 from_middle;
out vec4 fragment;
uniform vec4 line_color;
uniform vec3 eyePosition;
float lines(vec2 p, float spacing, float width) {
  vec2 q = p / spacing;
  vec2 per_pixel = fwidth(q);
  vec2 off = abs(fract(q - 0.5) - 0.5) / max(per_pixel, vec2(1e-6));
  vec2 line = clamp(width * 0.5 + 0.5 - off, 0.0, 1.0);
  line *= 1.0 - smoothstep(0.15, 0.45, per_pixel);
  return max(line.x, line.y);
}
void main() {
  float fine = 0.34 * lines(floor_position, 0.1, 1.0);
  float coarse = 0.95 * lines(floor_position, 1.0, 1.4);
  float fade = 1.0 - smoothstep(1.5, 6.0, length(from_middle));
  float alpha = max(fine * (1.0 - smoothstep(1.0, 3.2, length(from_middle))), coarse * fade);
  fragment = vec4(line_color.rgb, line_color.a * alpha);
}
)";

using Qt3DRender::QRenderPass;

QRenderPass* make_pass(const char* name, const char* vertex, const char* fragment) {
  auto* pass = new QRenderPass;
  auto* program = new Qt3DRender::QShaderProgram(pass);
  program->setVertexShaderCode(vertex);
  program->setFragmentShaderCode(fragment);
  pass->setShaderProgram(program);
  auto* key = new Qt3DRender::QFilterKey(pass);
  key->setName(QStringLiteral("pass"));
  key->setValue(QString::fromLatin1(name));
  pass->addFilterKey(key);
  return pass;
}

Qt3DRender::QEffect* make_effect(std::initializer_list<QRenderPass*> passes) {
  auto* effect = new Qt3DRender::QEffect;
  auto* technique = new Qt3DRender::QTechnique(effect);
  technique->graphicsApiFilter()->setApi(Qt3DRender::QGraphicsApiFilter::OpenGL);
  technique->graphicsApiFilter()->setProfile(Qt3DRender::QGraphicsApiFilter::CoreProfile);
  technique->graphicsApiFilter()->setMajorVersion(3);
  technique->graphicsApiFilter()->setMinorVersion(2);
  for (QRenderPass* pass : passes) {
    technique->addRenderPass(pass);
  }
  effect->addTechnique(technique);
  return effect;
}

QVector4D rgba(const QColor& color) {
  return {color.redF(), color.greenF(), color.blueF(), color.alphaF()};
}

}  // namespace

Qt3DRender::QGeometryRenderer* make_renderer(const TriangleMesh& mesh, Qt3DCore::QNode* parent) {
  QByteArray bytes;
  const std::size_t count = mesh.positions.size();
  bytes.resize(static_cast<qsizetype>(count) * 6 * static_cast<qsizetype>(sizeof(float)));
  auto* out = reinterpret_cast<float*>(bytes.data());
  for (std::size_t i = 0; i < count; ++i) {
    for (const Eigen::Vector3f* v : {&mesh.positions[i], &mesh.normals[i]}) {
      std::memcpy(out, v->data(), 3 * sizeof(float));
      out += 3;
    }
  }
  auto* renderer = new Qt3DRender::QGeometryRenderer(parent);
  auto* geometry = new Qt3DCore::QGeometry(renderer);
  auto* buffer = new Qt3DCore::QBuffer(geometry);
  buffer->setData(bytes);
  const auto attribute = [&](const QString& name, uint offset) {
    auto* a = new Qt3DCore::QAttribute(geometry);
    a->setName(name);
    a->setAttributeType(Qt3DCore::QAttribute::VertexAttribute);
    a->setVertexBaseType(Qt3DCore::QAttribute::Float);
    a->setVertexSize(3);
    a->setBuffer(buffer);
    a->setByteStride(6 * sizeof(float));
    a->setByteOffset(offset);
    a->setCount(static_cast<uint>(count));
    geometry->addAttribute(a);
    return a;
  };
  geometry->setBoundingVolumePositionAttribute(attribute(Qt3DCore::QAttribute::defaultPositionAttributeName(), 0));
  attribute(Qt3DCore::QAttribute::defaultNormalAttributeName(), 3 * sizeof(float));
  renderer->setGeometry(geometry);
  renderer->setPrimitiveType(Qt3DRender::QGeometryRenderer::Triangles);
  return renderer;
}

SurfaceMaterial::SurfaceMaterial(Kind kind, Qt3DCore::QNode* parent)
    : QMaterial(parent),
      color_(new Qt3DRender::QParameter(QStringLiteral("surface_color"), QVector4D(1, 1, 1, 1), this)),
      shadow_color_(new Qt3DRender::QParameter(QStringLiteral("shadow_color"), QVector4D(0, 0, 0, 1), this)) {
  switch (kind) {
    case Kind::kSolid:
      setEffect(make_effect({make_pass("solid", kSurfaceVertex, kSurfaceFragment)}));
      break;
    case Kind::kSolidWithShadow:
      setEffect(make_effect(
          {make_pass("shadow", kShadowVertex, kShadowFragment), make_pass("solid", kSurfaceVertex, kSurfaceFragment)}));
      break;
    case Kind::kTranslucent:
      setEffect(make_effect({make_pass("translucent", kSurfaceVertex, kSurfaceFragment)}));
      break;
    case Kind::kFlat:
      setEffect(make_effect({make_pass("solid", kSurfaceVertex, kFlatFragment)}));
      break;
  }
  addParameter(color_);
  addParameter(shadow_color_);
}

void SurfaceMaterial::set_color(const QColor& color) {
  color_->setValue(QVariant::fromValue(rgba(color)));
}

void SurfaceMaterial::set_shadow_color(const QColor& color) {
  shadow_color_->setValue(QVariant::fromValue(rgba(color)));
}

FloorMaterial::FloorMaterial(Qt3DCore::QNode* parent)
    : QMaterial(parent), color_(new Qt3DRender::QParameter(QStringLiteral("line_color"), QVector4D(1, 1, 1, 1), this)) {
  setEffect(make_effect({make_pass("floor", kFloorVertex, kFloorFragment)}));
  addParameter(color_);
}

void FloorMaterial::set_color(const QColor& line) {
  color_->setValue(QVariant::fromValue(rgba(line)));
}

FrameGraph make_frame_graph(Qt3DRender::QCamera* camera, QObject* surface, Qt3DCore::QNode* parent) {
  using namespace Qt3DRender;  // Twenty of its names follow.
  FrameGraph graph;
  graph.root = new QRenderSurfaceSelector(parent);
  graph.root->setSurface(surface);
  auto* viewport = new QViewport(graph.root);
  viewport->setNormalizedRect(QRectF(0, 0, 1, 1));
  auto* selector = new QCameraSelector(viewport);
  selector->setCamera(camera);

  const auto branch = [&](const char* pass, std::initializer_list<QRenderState*> states) {
    auto* filter = new QRenderPassFilter(selector);
    auto* key = new QFilterKey(filter);
    key->setName(QStringLiteral("pass"));
    key->setValue(QString::fromLatin1(pass));
    filter->addMatch(key);
    auto* set = new QRenderStateSet(filter);
    for (QRenderState* state : states) {
      set->addRenderState(state);
    }
    set->addRenderState(new QMultiSampleAntiAliasing);
    return set;
  };
  const auto depth = [](QDepthTest::DepthFunction function) {
    auto* test = new QDepthTest;
    test->setDepthFunction(function);
    return test;
  };
  const auto cull = [](QCullFace::CullingMode mode) {
    auto* state = new QCullFace;
    state->setMode(mode);
    return state;
  };
  const auto blend = [] {
    auto* arguments = new QBlendEquationArguments;
    arguments->setSourceRgb(QBlendEquationArguments::SourceAlpha);
    arguments->setDestinationRgb(QBlendEquationArguments::OneMinusSourceAlpha);
    arguments->setSourceAlpha(QBlendEquationArguments::Zero);
    arguments->setDestinationAlpha(QBlendEquationArguments::One);
    return arguments;
  };

  graph.clear = new QClearBuffers(selector);
  graph.clear->setBuffers(QClearBuffers::ColorDepthBuffer);
  new QNoDraw(graph.clear);
  branch("shadow", {depth(QDepthTest::Always), new QNoDepthMask, cull(QCullFace::NoCulling)});
  branch("floor", {depth(QDepthTest::Always), new QNoDepthMask, cull(QCullFace::NoCulling), blend()});
  branch("solid", {depth(QDepthTest::Less), cull(QCullFace::NoCulling)});
  // Only front faces, so that each bone of the ghost covers a pixel once.
  auto* translucent = branch("translucent", {depth(QDepthTest::LessOrEqual), cull(QCullFace::Back), blend()});
  auto* sort = new QSortPolicy(translucent);
  sort->setSortTypes(QVector<QSortPolicy::SortType>{QSortPolicy::BackToFront});
  graph.capture = new QRenderCapture(sort);
  return graph;
}

}  // namespace limbwave::ui
