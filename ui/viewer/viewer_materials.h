/// Qt3D building blocks of the viewer's scene: meshes, materials and the order of drawing.
#pragma once

#include <QColor>
#include <Qt3DCore/QEntity>
#include <Qt3DCore/QGeometry>
#include <Qt3DRender/QCamera>
#include <Qt3DRender/QClearBuffers>
#include <Qt3DRender/QFrameGraphNode>
#include <Qt3DRender/QGeometryRenderer>
#include <Qt3DRender/QMaterial>
#include <Qt3DRender/QParameter>
#include <Qt3DRender/QRenderCapture>
#include <Qt3DRender/QRenderSurfaceSelector>

#include "viewer/bone_shapes.h"

namespace limbwave::ui {

/// Uploads a mesh; several entities may share the result.
Qt3DRender::QGeometryRenderer* make_renderer(const TriangleMesh& mesh, Qt3DCore::QNode* parent);

/// A lit surface of one colour. With a shadow it is also drawn flat onto the floor; translucent ones come last.
class SurfaceMaterial : public Qt3DRender::QMaterial {
  Q_OBJECT
 public:
  enum class Kind { kSolid, kSolidWithShadow, kTranslucent, kFlat };
  SurfaceMaterial(Kind kind, Qt3DCore::QNode* parent);
  void set_color(const QColor& color);
  void set_shadow_color(const QColor& color);

 private:
  Qt3DRender::QParameter* color_;
  Qt3DRender::QParameter* shadow_color_;
};

/// The floor: lines every 10 cm and every metre that fade with the distance.
class FloorMaterial : public Qt3DRender::QMaterial {
  Q_OBJECT
 public:
  explicit FloorMaterial(Qt3DCore::QNode* parent);
  void set_color(const QColor& line);

 private:
  Qt3DRender::QParameter* color_;
};

/// Order of drawing: clear, shadows, floor, solid things, translucent things.
struct FrameGraph {
  Qt3DRender::QRenderSurfaceSelector* root = nullptr;
  Qt3DRender::QClearBuffers* clear = nullptr;
  Qt3DRender::QRenderCapture* capture = nullptr;
};
FrameGraph make_frame_graph(Qt3DRender::QCamera* camera, QObject* surface, Qt3DCore::QNode* parent);

}  // namespace limbwave::ui
