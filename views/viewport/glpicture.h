// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QOpenGLFunctions_3_3_Core>
#include <QOpenGLShaderProgram>
#include <QRect>
#include <QSize>
#include <QStringList>
#include <QVector4D>

#include <memory>

namespace views {

using ShaderProgram = std::unique_ptr<QOpenGLShaderProgram>;

/// Of which files (in ":/shaders/") a program is made.
struct ShaderFiles
{
    QString vertex, fragment;
    QString geometry;        ///< empty: none
    QStringList before = {}; ///< put before the fragment shader, after lighting.glsl
};

/// Compiles a program with OpenGL's context current. \param error  the driver's words, if it is still empty
ShaderProgram makeProgram(const ShaderFiles &files, const QByteArray &defines, QString &error);

/// Sets all state that a picture counts on: QPainter leaves its own behind.
/// \param size  in pixels of the framebuffer that is bound
/// \param part  pixels from its lower left corner: only they are cleared and drawn; empty: all
void setPictureState(QOpenGLFunctions_3_3_Core &gl, QSize size, const QRect &part = {});
/// Clears colour and depth, within what setPictureState() has set.
void clearPicture(QOpenGLFunctions_3_3_Core &gl);

/// A colour of the screen as light, with its opacity.
QVector4D linear(const QColor &color);

/// What lies behind everything in a 3D view. Made, used and destroyed with the same context current.
class Backdrop final
{
public:
    Backdrop(QOpenGLFunctions_3_3_Core &gl, QString &error);
    ~Backdrop();
    Backdrop(const Backdrop &) = delete;
    Backdrop &operator=(const Backdrop &) = delete;

    void draw(float aspect, bool isDark);

private:
    QOpenGLFunctions_3_3_Core &mGl;
    ShaderProgram mProgram;
    GLuint mEmptyArray = 0;
};

} // namespace views
