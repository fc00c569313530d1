// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/viewport/glsupport.h"

#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QSurfaceFormat>

#include <utility>

namespace views {

namespace {

constexpr std::pair<int, int> NeededVersion{3, 3};

QString glString(QOpenGLFunctions &gl, GLenum name)
{
    return QString::fromLatin1(reinterpret_cast<const char *>(gl.glGetString(name)));
}

GlSupport probe()
{
    const QString simulated = qEnvironmentVariable("SANDREEL_OPENGL");
    if (simulated == "none")
        return {};
    if (simulated == "old")
        return {false, false, "2.1 (simulated)", "simulated"};
    // Qt 6.4 crashes where these platforms are asked for a context.
    const QString platform = QGuiApplication::platformName();
    if (platform.startsWith("offscreen") || platform.startsWith("minimal") || platform == "vnc")
        return {};

    QOpenGLContext context;
    QOffscreenSurface surface;
    surface.setFormat(context.format());
    surface.create();
    if (!context.create() || !surface.isValid() || !context.makeCurrent(&surface))
        return {};
    GlSupport support;
    QOpenGLFunctions &gl = *context.functions();
    support.version = glString(gl, GL_VERSION);
    support.renderer = glString(gl, GL_RENDERER);
    const QSurfaceFormat format = context.format();
    support.isSufficient =
        !context.isOpenGLES() && std::pair(format.majorVersion(), format.minorVersion()) >= NeededVersion;
    for (const char *name : {"llvmpipe", "softpipe", "SwiftShader", "Software Rasterizer", "GDI Generic", "SWR"})
        support.isSoftware = support.isSoftware || support.renderer.contains(QLatin1String(name), Qt::CaseInsensitive);
    context.doneCurrent();
    return support;
}

} // namespace

const GlSupport &glSupport()
{
    static const GlSupport support = probe();
    return support;
}

void setDefaultGlFormat()
{
    QSurfaceFormat format;
    format.setVersion(NeededVersion.first, NeededVersion.second);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    QSurfaceFormat::setDefaultFormat(format);
}

} // namespace views
