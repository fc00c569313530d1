// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/terraindocument.h"
#include "model/haptics/service/hapticsservice.h"
#include "views/haptics/devicefinder.h"
#include "views/sculpt/strokecontroller.h"

#include <QObject>
#include <QPointer>
#include <QTimer>

#include <memory>
#include <optional>
#include <vector>

namespace views {

/// How a person wants the ground to feel. No part of a document.
struct FeelSettings
{
    model::haptics::LawKind law = model::haptics::LawKind::Granular;
    /// Instead of what the ground is made of; nothing: as the ground is.
    std::optional<model::terrain::MaterialPreset> material;
    double gain = 1;
    double maxForce = 4; ///< N
};

/// A device at the ground of one terrain: the servo feels what the document shows, and what is done with the button
/// becomes strokes, through the same controller as the mouse's.
///
/// While the button is down there is one stroke, so one step of the history. The servo gets a copy of the ground around
/// the tool, made here between two events, and never sees the document. Forces are off at the start, when a device is
/// chosen, when it is unplugged, and when another terrain is in front.
class HapticsSession final : public QObject
{
    Q_OBJECT

public:
    /// \param settings  of the tool that the device holds; outlives this
    HapticsSession(std::shared_ptr<model::haptics::HidSystem> system, const ToolSettings &settings,
                   QObject *parent = nullptr);
    ~HapticsSession() override;

    DeviceFinder &finder() { return mFinder; }
    /// Opens the device that the finder knows by this id, instead of the one before; empty: none.
    void choose(const QString &id);
    /// The simulated device as the caller has prepared it.
    void chooseSimulated(std::unique_ptr<model::haptics::SimulatedDevice> device);
    /// Of the open device; empty if none is open.
    const QString &chosen() const { return mChosen; }
    model::haptics::HapticsService &service() { return mService; }
    const model::haptics::HapticsService &service() const { return mService; }

    /// The ground that is felt and stroked. null: none. A stroke that goes on ends. Both must be taken away before they
    /// are destroyed.
    void setTerrain(const model::TerrainDocument *document, StrokeController *strokes);
    bool hasTerrain() const { return mDocument; }

    const FeelSettings &feel() const { return mFeel; }
    void setFeel(const FeelSettings &feel);

    /// Nothing happens without a device that has forces.
    void setForces(bool isOn);
    bool wantsForces() const { return mService.wantsForces(); }

    /// Moves the simulated device to a place in the terrain, in local metres. Nothing happens with another device.
    void moveHand(const model::terrain::Point3 &place, bool isPressed);
    /// Of the device now, in the terrain.
    model::terrain::Point3 toolPlace() const;
    /// Takes back the stroke that goes on; the button does nothing until it is let go.
    void cancelStroke();
    bool isStroking() const { return mIsStroking; }

    /// The steps of the servo since the last stepped().
    const std::vector<model::haptics::ServoSample> &samples() const { return mSamples; }
    /// The last one.
    const model::haptics::ServoSample &now() const { return mNow; }

signals:
    /// Another device is open, or none.
    void chosenChanged();
    /// Forces are wanted, or not.
    void forcesChanged(bool isOn);
    void feelChanged();
    /// samples() has news. Some hundred times a second at most.
    void stepped();
    /// A device could not be opened. \param reason  for people
    void refused(const QString &reason);

private:
    void opened(const QString &id);
    void publishSettings();
    void publishGround();
    void step();
    void heed(const model::haptics::ServoSample &sample);
    void press(const model::haptics::ServoSample &sample);
    void endStroke();
    GroundEvent eventAt(const model::haptics::ServoSample &sample) const;

    const ToolSettings &mSettings;
    std::shared_ptr<model::haptics::HidSystem> mSystem;
    model::haptics::HapticsService mService;
    DeviceFinder mFinder;
    FeelSettings mFeel;
    QString mChosen;
    const model::TerrainDocument *mDocument = nullptr;
    model::terrain::Point3 mOrigin; ///< of the hand. Strokes change the ground, not this
    QPointer<StrokeController> mStrokes;
    QMetaObject::Connection mChanges;
    QTimer mTimer;
    std::vector<model::haptics::ServoSample> mSamples;
    model::haptics::ServoSample mNow;
    bool mWasConnected = true;
    bool mMustLetGo = false; ///< the button counts only after it was up
    bool mIsStroking = false;
    model::haptics::ServoSample mLastOfStroke;
    model::Vec3d mHovered; ///< of the hand, when the tool's outline was last moved
};

} // namespace views
