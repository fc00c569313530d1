// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/sculpt/backgroundedit.h"

#include "model/io/errortext.h"

namespace views {

using namespace model::terrain;

BackgroundEdit::BackgroundEdit(commands::TerrainContext &context, QObject *parent)
    : QObject(parent)
    , mContext(context)
{
    connect(&mContext.document(), &model::TerrainDocument::changed, this, [this] {
        ++mChanges;
        mJob.cancel();
    });
}

void BackgroundEdit::start(const QString &text, Work work)
{
    mContext.endGesture();
    mJob.start(
        [copy = mContext.document().copier(),
         work = std::move(work)](const model::Progress &progress) -> model::Result<Edit> {
            Terrain terrain = copy();
            TinEdit open(terrain.tin);
            if (auto done = work(open, progress); !done)
                return model::fail(std::move(done.error()));
            if (progress.isCancelled())
                return model::fail(model::ErrorCode::Cancelled);
            Edit edit = open.commit();
            // Undone here, it leads from what the document is to what came of it.
            if (!edit.isEmpty())
                terrain.tin.swap(edit);
            return edit;
        },
        [this, text, changes = mChanges](model::Result<Edit> edit) {
            if (!edit) {
                if (edit.error().code != model::ErrorCode::Cancelled)
                    emit failed(model::io::errorText(edit.error()));
                return;
            }
            if (changes != mChanges)
                return;
            if (!edit->isEmpty())
                mContext.push<commands::EditSurface>(text, std::move(*edit));
            emit finished();
        });
}

} // namespace views
