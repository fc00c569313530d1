// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/animation/animationcontext.h"
#include "model/animation/metrics.h"
#include "views/docks/filefacts.h"
#include "views/jobs/job.h"

#include <QDockWidget>
#include <QPointer>

#include <optional>

class QFormLayout;
class QLabel;
class QPushButton;
class QTreeWidget;

namespace views {

class CompressionFields;
class HintLabel;
class JobPanel;

/// How the animation will be compressed when it is saved, what its file is like now, and, on demand, what the settings
/// would make of it: size and errors, measured in the background.
class CompressionDock final : public QDockWidget
{
    Q_OBJECT

public:
    explicit CompressionDock(QWidget *parent = nullptr);
    ~CompressionDock() override;

    /// \param context  null: no document; let go of by itself when it is destroyed
    /// \param facts    of the document's file, if it has one
    void setDocument(commands::AnimationContext *context, const std::optional<FileFacts> &facts);

protected:
    void changeEvent(QEvent *event) override;

private:
    /// What the present settings would give.
    struct Measurement
    {
        std::uint64_t bytes = 0;
        std::uint64_t rawBytes = 0;
        double bitsPerVertexFrame = 0;
        model::ComparisonResult errors;
    };

    static model::Result<Measurement> measured(const model::FrameSource &frames,
                                               const model::CompressionSettings &settings,
                                               const model::Progress &progress);
    void build();
    QWidget *makeSettingsPart(QWidget *parent);
    QWidget *makeFilePart(QWidget *parent);
    QWidget *makeMeasurePart(QWidget *parent);
    void editSettings();
    void showSettings();
    void showFacts();
    void showMeasurement();
    void measure();

    QPointer<commands::AnimationContext> mContext;
    std::optional<FileFacts> mFacts;
    std::optional<Measurement> mMeasurement;
    commands::GestureId mGesture = commands::NoGesture;
    QMetaObject::Connection mChanges;

    QWidget *mSettingsPart = nullptr;
    CompressionFields *mFields = nullptr;
    QWidget *mFilePart = nullptr;
    QLabel *mFactValues[6] = {};
    QTreeWidget *mChunks = nullptr;
    QPushButton *mMeasure = nullptr;
    HintLabel *mMeasured = nullptr;
    Job mMeasuring;
};

} // namespace views
