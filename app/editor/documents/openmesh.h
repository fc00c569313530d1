// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/editor/documents/document.h"
#include "commands/mesh/meshcontext.h"
#include "views/inspect/inspection.h"

#include <functional>
#include <memory>

namespace editor {

/// A mesh and what is known of it. Opened from a file, or a frame of an animation: then it has no path until it is
/// saved.
class OpenMesh final : public Document
{
    Q_OBJECT

public:
    explicit OpenMesh(QObject *parent = nullptr);
    ~OpenMesh() override;

    /// What a mesh is made from that is in no file.
    struct Made
    {
        model::PolygonMesh mesh;
        std::vector<views::FieldOffer> fields; ///< numbers at its vertices, as long as it is not edited
    };
    /// Begins to make it; opened() or failed() follow, as with open().
    void create(const QString &name, std::function<model::Result<Made>(const model::Progress &)> make);

    DocumentKind kind() const override { return DocumentKind::Mesh; }
    QString title() const override;
    QString origin() const override;
    QString summary() const override;
    /// That it may be a frame of an animation.
    QString warning() const override;
    bool isModified() const override;
    commands::MeshContext *context() const override { return mContext.get(); }

    /// Precondition: isOpen().
    const model::MeshDocument &mesh() const { return *mDocument; }
    views::Inspection &inspection() { return mInspection; }

protected:
    void read(const QString &path) override;
    void write(const QString &path) override;

private:
    struct Opened
    {
        Made made;
        FileStamp stamp;
        int alike = 1; ///< files that have its name but for the number
    };
    void start(std::function<model::Result<Opened>(const model::Progress &)> work);
    void take(Opened opened);
    /// \param moreFields  beside those that its shape gives
    void inspect(std::vector<views::FieldOffer> moreFields);

    QString mName; ///< of what is in no file
    int mAlike = 1;
    std::unique_ptr<model::MeshDocument> mDocument;
    std::unique_ptr<commands::MeshContext> mContext;
    views::Inspection mInspection;
};

} // namespace editor
