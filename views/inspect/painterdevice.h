// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFont>
#include <QPen>
#include <QSizeF>
#include <QTransform>

#include <vector>

#include <vtkContextDevice2D.h>
#include <vtkUnicodeString.h>

class QPainter;

namespace views {

/// What VTK's charts are drawn with: a QPainter. Text has the program's font and all its letters, lines have the width
/// of the screen's units at any pixel ratio, and what the painter paints on may be a vector file. Private to
/// views/inspect.
class PainterDevice final : public vtkContextDevice2D
{
public:
    static PainterDevice *New();
    vtkTypeMacro(PainterDevice, vtkContextDevice2D)

        /// \param size  of the scene, whose y points up
        void setPainter(QPainter *painter, QSizeF size);

    void DrawPoly(float *points, int n, unsigned char *colors, int components) override;
    void DrawLines(float *points, int n, unsigned char *colors, int components) override;
    void DrawPoints(float *points, int n, unsigned char *colors, int components) override;
    void DrawPointSprites(vtkImageData *, float *points, int n, unsigned char *colors, int components) override;
    void DrawMarkers(int shape, bool highlight, float *points, int n, unsigned char *colors, int components) override;
    void DrawQuad(float *points, int n) override { fill(points, n); }
    void DrawQuadStrip(float *points, int n) override;
    void DrawPolygon(float *points, int n) override { fill(points, n); }
    void DrawColoredPolygon(float *points, int n, unsigned char *, int) override { fill(points, n); }
    void DrawEllipseWedge(float x, float y, float outRx, float outRy, float inRx, float inRy, float start,
                          float stop) override;
    void DrawEllipticArc(float x, float y, float rX, float rY, float start, float stop) override;
    void DrawString(float *point, const vtkStdString &text) override;
    void ComputeStringBounds(const vtkStdString &text, float bounds[4]) override;
    void DrawString(float *point, const vtkUnicodeString &text) override;
    void ComputeStringBounds(const vtkUnicodeString &text, float bounds[4]) override;
    void ComputeJustifiedStringBounds(const char *text, float bounds[4]) override;
    void DrawMathTextString(float *point, const vtkStdString &text) override { DrawString(point, text); }
    void DrawImage(float *, float, vtkImageData *) override {}
    void DrawImage(const vtkRectf &, vtkImageData *) override {}
    void SetColor4(unsigned char *) override {}
    void SetTexture(vtkImageData *, int) override {}
    void SetPointSize(float size) override;
    void SetLineWidth(float width) override;
    void SetLineType(int type) override;
    void SetMatrix(vtkMatrix3x3 *matrix) override;
    void GetMatrix(vtkMatrix3x3 *matrix) override;
    void MultiplyMatrix(vtkMatrix3x3 *matrix) override;
    void PushMatrix() override { mStack.push_back(mTransform); }
    void PopMatrix() override;
    void SetClipping(int *area) override;
    void EnableClipping(bool enable) override;

protected:
    PainterDevice();
    ~PainterDevice() override;

private:
    QPointF place(float x, float y) const;
    QPen pen() const;
    QBrush brush() const;
    QFont font() const;
    void fill(const float *points, int n);

    QPainter *mPainter = nullptr;
    QSizeF mSize;
    QTransform mTransform; ///< of the scene
    std::vector<QTransform> mStack;
    QRectF mClip;
};

} // namespace views
