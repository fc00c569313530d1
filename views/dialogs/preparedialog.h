// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/dialogs/encoding.h"
#include "views/dialogs/foundsource.h"
#include "views/jobs/job.h"

#include <QDialog>

#include <optional>

class QFormLayout;
class QGroupBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace views {

class CompressionFields;
class FramePreview;
class HintLabel;
class InputLine;
class JobPanel;
class NormalisationChoice;
class NumberField;
class PathField;
class QualityPanel;
class TriesPanel;

/// Prepare Animation: from a folder of meshes, a point cache or a scene to an `.anim`. Not modal; reads and encodes in
/// the background, and keeps what was tried, for comparison.
class PrepareDialog final : public QDialog
{
    Q_OBJECT

public:
    explicit PrepareDialog(QWidget *parent = nullptr);
    ~PrepareDialog() override;

    /// As if `path` had been typed: for drops and the command line.
    void setSource(const QString &path);
    bool isEncoding() const { return mEncoding.isRunning(); }

public slots:
    /// Close, Escape: asks if an encoding runs.
    void reject() override;

signals:
    /// \param original  what the file was made of
    void openRequested(const QString &path, const views::OriginalPtr &original);

protected:
    void dragEnterEvent(QDragEnterEvent *event) override;
    void dropEvent(QDropEvent *event) override;

private:
    QWidget *makeSourcePart();
    QWidget *makeSettingsPart();
    QWidget *makeFoundPart();
    QWidget *makeButtons();
    void restoreSettings();
    void saveSettings() const;

    void sourceEdited();
    void readSourceNow();
    void showFound(model::Result<FoundSource> result);
    void showReading(bool running);
    void proposeOutput();
    void showResolutionMeaning();
    void tellQuality();

    QString outputPath() const;
    QString problem() const;
    void updateEncodeButton();
    bool mayOverwrite(const QString &output);
    void encode();
    void showEncoded(model::Result<EncodingReport> result);
    void encodeAgain();

    std::optional<FoundSource> mFound;
    QString mTriedSource;    ///< what the tries were made of
    QString mProposedOutput; ///< still ours to replace while the field shows it
    QString mProposedName;
    double mProposedRate = 0;

    PathField *mSource;
    PathField *mBaseMesh;
    NumberField *mBakeRate;
    QSpinBox *mAnimation;
    HintLabel *mSourceMessage;
    QFormLayout *mSourceForm;

    QLabel *mFacts[6];
    FramePreview *mPreview;

    QLineEdit *mName;
    NumberField *mFrameRate;
    NormalisationChoice *mNormalisation;
    CompressionFields *mCompression;
    PathField *mOutput;
    HintLabel *mOutputHint;
    QWidget *mSettingsPart;

    QualityPanel *mQuality;
    QGroupBox *mTriesPart;
    TriesPanel *mTries;
    HintLabel *mMessage;
    QPushButton *mEncode;

    QTimer mReadDelay;
    // Last: destroyed first, so that no result arrives in a dialog that is half gone.
    Job mReading;
    Job mEncoding;
    JobPanel *mEncodingPanel;
};

} // namespace views
