// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/terrain/groundcolors.h"
#include "views/terrain/picture/groundmaps.h"
#include "views/terrain/picture/terrainpicture.h"
#include "views/viewport/glpicture.h"

#include <map>

namespace views {

/// The programs that colour the ground, and what they are told. Made, used and destroyed with the same context current.
class GroundShading final
{
public:
    GroundShading(QOpenGLFunctions_3_3_Core &gl, const GroundFrame &frame, QString &error);
    ~GroundShading();
    GroundShading(const GroundShading &) = delete;
    GroundShading &operator=(const GroundShading &) = delete;

    struct Scene
    {
        const TerrainPicture &picture;
        const GroundMaps &maps;
        bool hasShadows = false;    ///< the maps' light is used
        bool isGrid = false;        ///< drawGrid() comes next
        GroundRange range;          ///< of the overlay
        double contourInterval = 0; ///< metres; 0: no contours
    };
    /// Makes the program for a scene the current one and tells it all but the matrices; null if it did not compile.
    QOpenGLShaderProgram *use(const Scene &scene);
    /// A grid of squares over the maps instead of the terrain; after use() with isGrid.
    void drawGrid(QOpenGLShaderProgram &program, const GroundMaps &maps);
    /// Triangles that drawGrid() draws.
    static constexpr std::uint32_t gridTriangles() { return 2 * GridSquares * GridSquares; }

private:
    static constexpr int GridSquares = 200; ///< along a side

    QOpenGLShaderProgram *programFor(const TerrainStyle &style, bool isGrid);
    void setOverlay(QOpenGLShaderProgram &program, const Scene &scene);

    QOpenGLFunctions_3_3_Core &mGl;
    const GroundFrame &mFrame;
    QString &mError;
    std::map<QByteArray, ShaderProgram> mPrograms; ///< by their defines
    GLuint mGrains = 0, mEmptyArray = 0;
};

/// Towards the sun, unit, in the scene's axes.
model::Vec3f sunDirection(const TerrainStyle &style);

} // namespace views
