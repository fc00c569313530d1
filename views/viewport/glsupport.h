// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace views {

/// What OpenGL this machine offers, found without opening a window. To be asked before any QOpenGLWidget is shown: Qt
/// 6.4 crashes rather than reports without a context.
struct GlSupport
{
    bool isSufficient = false; ///< OpenGL 3.3 core or newer
    bool isSoftware = false;   ///< drawn by the processor: multisampling is too dear then
    QString version;           ///< "4.5 (Core Profile) Mesa 22.3.6", empty if there is none
    QString renderer;
};

/// The result is kept; the first call takes some 50 ms. Call in the GUI thread after QApplication exists.
/// The environment variable SANDREEL_OPENGL, "none" or "old", simulates such a machine.
const GlSupport &glSupport();

/// Sets the default surface format (3.3 core, depth 24). Call before QApplication is made.
void setDefaultGlFormat();

} // namespace views
