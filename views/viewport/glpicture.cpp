// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/viewport/glpicture.h"

#include <QFile>
#include <QVector3D>

#include <cmath>

namespace views {

namespace {

QByteArray contentsOf(const QString &name)
{
    QFile file(":/shaders/" + name);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

float toLinear(float encoded)
{
    return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

} // namespace

ShaderProgram makeProgram(const ShaderFiles &files, const QByteArray &defines, QString &error)
{
    const QByteArray start = "#version 330 core\n" + defines;
    QByteArray fragment = start + contentsOf(QStringLiteral("lighting.glsl"));
    for (const QString &file : files.before)
        fragment += contentsOf(file);
    fragment += contentsOf(files.fragment);
    auto program = std::make_unique<QOpenGLShaderProgram>();
    const bool isGood =
        program->addShaderFromSourceCode(QOpenGLShader::Vertex, start + contentsOf(files.vertex)) &&
        (files.geometry.isEmpty() ||
         program->addShaderFromSourceCode(QOpenGLShader::Geometry, start + contentsOf(files.geometry))) &&
        program->addShaderFromSourceCode(QOpenGLShader::Fragment, fragment) && program->link();
    if (!isGood && error.isEmpty())
        error = files.vertex + ", " + files.fragment + ": " + program->log();
    return program;
}

void setPictureState(QOpenGLFunctions_3_3_Core &gl, QSize size, const QRect &part)
{
    gl.glViewport(0, 0, size.width(), size.height());
    if (part.isEmpty()) {
        gl.glDisable(GL_SCISSOR_TEST);
    } else {
        gl.glEnable(GL_SCISSOR_TEST);
        gl.glScissor(part.x(), part.y(), part.width(), part.height());
    }
    gl.glDisable(GL_STENCIL_TEST);
    gl.glDisable(GL_BLEND);
    gl.glDisable(GL_CULL_FACE);
    gl.glEnable(GL_MULTISAMPLE); // QPainter leaves it off
    gl.glEnable(GL_DEPTH_TEST);
    gl.glEnable(GL_PROGRAM_POINT_SIZE);
    gl.glDepthFunc(GL_LEQUAL);
    gl.glDepthMask(GL_TRUE);
    gl.glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    // The alpha of the picture stays 1: a window would show through otherwise.
    gl.glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
}

void clearPicture(QOpenGLFunctions_3_3_Core &gl)
{
    gl.glClearColor(0.1f, 0.1f, 0.12f, 1);
    gl.glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

QVector4D linear(const QColor &color)
{
    return {toLinear(color.redF()), toLinear(color.greenF()), toLinear(color.blueF()), color.alphaF()};
}

Backdrop::Backdrop(QOpenGLFunctions_3_3_Core &gl, QString &error)
    : mGl(gl)
    , mProgram(makeProgram({QStringLiteral("fullscreen.vert"), QStringLiteral("background.frag"), {}}, {}, error))
{
    mGl.glGenVertexArrays(1, &mEmptyArray);
}

Backdrop::~Backdrop()
{
    mGl.glDeleteVertexArrays(1, &mEmptyArray);
}

void Backdrop::draw(float aspect, bool isDark)
{
    mGl.glDepthMask(GL_FALSE);
    mGl.glDisable(GL_DEPTH_TEST);
    mProgram->bind();
    mProgram->setUniformValue("uTop", linear(isDark ? QColor(66, 75, 90) : QColor(250, 251, 253)).toVector3D());
    mProgram->setUniformValue("uBottom", linear(isDark ? QColor(21, 24, 30) : QColor(186, 194, 206)).toVector3D());
    mProgram->setUniformValue("uAspect", aspect);
    mGl.glBindVertexArray(mEmptyArray);
    mGl.glDrawArrays(GL_TRIANGLES, 0, 3);
    mGl.glBindVertexArray(0);
    mGl.glEnable(GL_DEPTH_TEST);
    mGl.glDepthMask(GL_TRUE);
}

} // namespace views
