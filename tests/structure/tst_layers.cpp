// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/testmain.h"

#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>

/// Who may include whom, checked on the text of every source: linking catches only what has symbols.
class TestLayers final : public QObject
{
    Q_OBJECT

    /// For a folder, the prefixes of includes that none of its files may have.
    static QList<std::pair<QString, QStringList>> rules()
    {
        const QStringList widgets{"QtWidgets",   "QWidget", "QDialog",    "QMainWindow",
                                  "QDockWidget", "QOpenGL", "QMouseEvent"};
        const QStringList gui =
            widgets + QStringList{"QUndo", "QImage",          "QIcon",   "QColor", "QPainter", "QPixmap",
                                  "QFont", "QGuiApplication", "QAction", "QKey",   "QWindow"};
        const QStringList above{"commands/", "views/", "app/", "tests/", "vtk"};
        const QStringList noQt = above + QStringList{"Q"};
        const auto order = [&](QStringList laterAreas, const QStringList &rest) {
            for (QString &area : laterAreas)
                area = "model/" + area + "/";
            return laterAreas + rest;
        };
        return {
            {"model/base",
             order({"geometry", "mesh", "animation", "codec", "document", "io", "room", "terrain", "haptics"}, noQt)},
            {"model/geometry",
             order({"mesh", "animation", "codec", "document", "io", "room", "terrain", "haptics"}, noQt)},
            {"model/mesh", order({"animation", "codec", "document", "io", "room", "terrain", "haptics"}, noQt)},
            {"model/animation", order({"codec", "document", "io", "room", "terrain", "haptics"}, noQt)},
            {"model/codec", order({"document", "io", "room", "terrain", "haptics"}, noQt)},
            {"model/terrain", order({"mesh", "animation", "codec", "document", "io", "room", "haptics"}, noQt)},
            {"model/haptics", order({"codec", "document", "io", "room"}, noQt)},
            {"model/document", order({"codec", "io", "room"}, above + gui)},
            {"model/io", order({"room"}, above + gui)},
            {"commands", QStringList{"views/", "app/", "tests/", "vtk"} + widgets},
            {"views", {"app/", "tests/"}},
            {"app", {"tests/"}},
        };
    }

    static QStringList productFolders() { return {"model", "commands", "views", "app"}; }
    static QStringList everyFolder() { return productFolders() + QStringList{"tests"}; }

    static QStringList sourcesIn(const QString &folder)
    {
        QStringList files;
        QDirIterator it(QStringLiteral(SANDREEL_SOURCE_DIR "/") + folder, {"*.h", "*.cpp"}, QDir::Files,
                        QDirIterator::Subdirectories);
        while (it.hasNext())
            files << it.next();
        return files;
    }

    static QStringList includesOf(const QString &path)
    {
        static const QRegularExpression include(QStringLiteral("^\\s*#\\s*include\\s*[<\"]([^>\"]+)[>\"]"),
                                                QRegularExpression::MultilineOption);
        QFile file(path);
        if (!file.open(QIODevice::ReadOnly))
            return {};
        QStringList result;
        auto matches = include.globalMatch(QString::fromUtf8(file.readAll()));
        while (matches.hasNext())
            result << matches.next().captured(1);
        return result;
    }

private slots:
    void noFileIncludesAForbiddenOne_data()
    {
        QTest::addColumn<QString>("folder");
        QTest::addColumn<QStringList>("forbidden");
        for (const auto &[folder, forbidden] : rules())
            QTest::newRow(qPrintable(folder)) << folder << forbidden;
    }
    void noFileIncludesAForbiddenOne()
    {
        QFETCH(QString, folder);
        QFETCH(QStringList, forbidden);
        const QStringList files = sourcesIn(folder);
        QVERIFY2(!files.isEmpty(), "the folder is empty: has it moved?");
        QStringList broken;
        for (const QString &file : files)
            for (const QString &included : includesOf(file))
                for (const QString &prefix : forbidden)
                    if (included.startsWith(prefix))
                        broken << file + " includes " + included;
        QVERIFY2(broken.isEmpty(), qPrintable(broken.join('\n')));
    }

    /// Third-party types stop at the files that adapt them.
    void librariesStayBehindTheirAdapters()
    {
        const QList<std::pair<QString, QString>> adapters{
            {"assimp/", "model/io/"},
            {"Eigen/", "model/codec/|model/mesh/editing/fairing.cpp"},
            {"CLI/", "app/"},
            {"gdal", "model/io/terrain/rasters/gdalraster.cpp"},
            {"ogr_", "model/io/terrain/rasters/gdalraster.cpp"},
            {"cpl_", "model/io/terrain/rasters/gdalraster.cpp"},
            {"zip.h", "model/io/terrain/zipfile.cpp"},
            {"CGAL/", "model/terrain/tin/exactpredicates.cpp|model/mesh/analysis/trianglepredicates.cpp|"
                      "model/mesh/editing/cgal"},
            {"hidapi", "model/haptics/hid/hidapisystem.cpp"},
            {"OpenMesh/", "model/mesh/editing/openmesh"},
            {"vtk", "views/inspect/"}};
        const auto isIn = [](const QString &rooms, const QString &file) {
            const QStringList all = rooms.split('|');
            return std::any_of(all.begin(), all.end(), [&](const QString &room) {
                return file.startsWith(QStringLiteral(SANDREEL_SOURCE_DIR "/") + room);
            });
        };
        QStringList broken;
        for (const QString &top : productFolders())
            for (const QString &file : sourcesIn(top))
                for (const QString &included : includesOf(file))
                    for (const auto &[library, room] : adapters)
                        if (included.startsWith(library) && !isIn(room, file))
                            broken << file + " includes " + included;
        QVERIFY2(broken.isEmpty(), qPrintable(broken.join('\n')));
    }

    void ownIncludesAreByFullPath()
    {
        QStringList broken;
        for (const QString &top : everyFolder())
            for (const QString &file : sourcesIn(top)) {
                QFile source(file);
                QVERIFY(source.open(QIODevice::ReadOnly));
                static const QRegularExpression quoted(QStringLiteral("^#include \"([^\"]+)\""),
                                                       QRegularExpression::MultilineOption);
                auto matches = quoted.globalMatch(QString::fromUtf8(source.readAll()));
                while (matches.hasNext()) {
                    const QString included = matches.next().captured(1);
                    if (!included.endsWith(".moc") &&
                        !QFile::exists(QStringLiteral(SANDREEL_SOURCE_DIR "/") + included))
                        broken << file + " includes " + included;
                }
            }
        QVERIFY2(broken.isEmpty(), qPrintable(broken.join('\n')));
    }

    void everySourceNamesItsLicence()
    {
        QStringList broken;
        for (const QString &top : everyFolder())
            for (const QString &file : sourcesIn(top)) {
                QFile source(file);
                QVERIFY(source.open(QIODevice::ReadOnly));
                if (source.readLine() != "// SPDX-License-Identifier: GPL-3.0-or-later\n")
                    broken << file;
            }
        QVERIFY2(broken.isEmpty(), qPrintable(broken.join('\n')));
    }

    void onlyTheAgreedFoldersAreAtTheTop()
    {
        const QStringList agreed{"app",       "build", "commands",     "docs", "model",
                                 "resources", "tests", "translations", "views"};
        for (const QString &folder :
             QDir(QStringLiteral(SANDREEL_SOURCE_DIR)).entryList(QDir::Dirs | QDir::NoDotAndDotDot))
            QVERIFY2(agreed.contains(folder), qPrintable(folder));
    }
};

SANDREEL_TEST(TestLayers)
#include "tst_layers.moc"
