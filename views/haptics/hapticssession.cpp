// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/haptics/hapticssession.h"

#include "model/io/errortext.h"
#include "views/haptics/hapticstexts.h"
#include "views/sculpt/toolvalues.h"

#include <algorithm>
#include <cmath>

namespace views {

using namespace model::haptics;
using namespace model::terrain;

namespace {

/// Between two snapshots of the ground, and two looks at the device: the servo's limit of their age is 50 ms.
constexpr int StepMilliseconds = 8;
/// m of the hand: the least and the most that the ring of the tool, as it is felt, is wide. Wider ones would feel the
/// ground of half the terrain.
constexpr double SmallestRing = 0.004, LargestRing = 0.03;
/// m of the hand, below the ground, at which a tool is pressed in with all its strength ...
constexpr double FullDepth = 0.02;
/// ... and the share of it with which it draws when it only touches.
constexpr double LightTouch = 0.1;
/// m of the hand: a tool that moves by less is still where it was.
constexpr double LeastMove = 1e-5;
/// Of the ring, for what is drawn on the ground in pixels.
constexpr double PixelsPerRing = 20;

} // namespace

HapticsSession::HapticsSession(std::shared_ptr<HidSystem> system, const ToolSettings &settings, QObject *parent)
    : QObject(parent)
    , mSettings(settings)
    , mSystem(std::move(system))
    , mService(mSystem)
    , mFinder(mSystem)
{
    mTimer.setTimerType(Qt::PreciseTimer);
    mTimer.setInterval(StepMilliseconds);
    connect(&mTimer, &QTimer::timeout, this, &HapticsSession::step);
    connect(&mSettings, &ToolSettings::toolChanged, this, &HapticsSession::publishSettings);
}

HapticsSession::~HapticsSession()
{
    setTerrain(nullptr, nullptr);
}

void HapticsSession::choose(const QString &id)
{
    if (id == mChosen)
        return;
    endStroke();
    const bool hadForces = wantsForces();
    mService.close();
    if (hadForces)
        emit forcesChanged(false);
    const std::vector<FoundDevice> &devices = mFinder.devices();
    const auto found = std::find_if(devices.begin(), devices.end(),
                                    [&](const FoundDevice &device) { return QString::fromStdString(device.id) == id; });
    if (found == devices.end())
        return opened({});
    if (auto open = mService.open(*found); !open) {
        opened({});
        emit refused(found->isAllowed ? model::io::errorText(open.error()) : hintOf(*found));
        return;
    }
    opened(id);
}

void HapticsSession::chooseSimulated(std::unique_ptr<SimulatedDevice> device)
{
    choose({});
    mService.openSimulated(std::move(device));
    opened(QString::fromStdString(simulatedDevice().id));
}

void HapticsSession::opened(const QString &id)
{
    mChosen = id;
    mNow = {};
    mSamples.clear();
    mWasConnected = true;
    mMustLetGo = true;
    mHovered = {};
    publishSettings();
    if (mService.isOpen())
        mTimer.start();
    else
        mTimer.stop();
    emit chosenChanged();
}

void HapticsSession::setTerrain(const model::TerrainDocument *document, StrokeController *strokes)
{
    if (document == mDocument && strokes == mStrokes)
        return;
    endStroke();
    setForces(false);
    disconnect(mChanges);
    mDocument = document;
    mStrokes = strokes;
    mMustLetGo = true;
    if (document) {
        const Rectangle domain = document->tin().domain();
        const Point2 middle{(domain.low.x + domain.high.x) / 2, (domain.low.y + domain.high.y) / 2};
        mOrigin = {middle.x, middle.y, document->tin().heightAt(middle)};
        mChanges = connect(document, &model::TerrainDocument::changed, this, &HapticsSession::publishGround);
    }
    publishSettings();
}

void HapticsSession::setFeel(const FeelSettings &feel)
{
    mFeel = feel;
    publishSettings();
    emit feelChanged();
}

void HapticsSession::setForces(bool isOn)
{
    const Capabilities *const device = mService.capabilities();
    isOn = isOn && device && device->hasForce && mDocument;
    if (isOn == wantsForces())
        return;
    mService.setForces(isOn);
    emit forcesChanged(isOn);
}

/// The middle of what the device reaches is the middle of the terrain, and its longer side is in reach.
void HapticsSession::publishSettings()
{
    ServoSettings settings = mService.settings();
    settings.law = mFeel.law;
    settings.gain = mFeel.gain;
    settings.limits.userForce = mFeel.maxForce;
    settings.overridesFeel = mFeel.material.has_value();
    if (mFeel.material) {
        const Material felt = material(*mFeel.material);
        settings.feel = feelOf(felt, felt.humidity);
    }
    const Capabilities *const device = mService.capabilities();
    if (mDocument && device) {
        const Rectangle domain = mDocument->tin().domain();
        const double side = std::max(domain.high.x - domain.low.x, domain.high.y - domain.low.y);
        const double reach = std::min(device->high.x - device->low.x, device->high.y - device->low.y);
        Workspace &workspace = settings.workspace;
        workspace.scale = side / reach;
        workspace.origin = mOrigin;
        workspace.toolRadius =
            std::clamp(radiusOf(mSettings.tool()) / workspace.scale, SmallestRing, LargestRing) * workspace.scale;
    }
    mService.setSettings(settings);
}

void HapticsSession::publishGround()
{
    if (mDocument && mService.isOpen())
        mService.publishGround(mDocument->terrain());
}

void HapticsSession::step()
{
    if (mIsStroking && !(mStrokes && mStrokes->isDrawing())) {
        mIsStroking = false; // undone in the midst of it
        mMustLetGo = true;
    }
    publishGround();
    mSamples.clear();
    mService.drain(mSamples);
    for (const ServoSample &sample : mSamples)
        heed(sample);
    if (mSamples.empty())
        return;
    mNow = mSamples.back();
    if (mIsStroking) {
        mLastOfStroke = mNow;
        mStrokes->move(eventAt(mNow));
    } else if (mStrokes && mDocument && !mStrokes->isDrawing() && mNow.reading.isConnected &&
               model::distance(mNow.reading.position, mHovered) > LeastMove) {
        mHovered = mNow.reading.position;
        mStrokes->hover(eventAt(mNow));
    }
    emit stepped();
}

/// Each of the thousand a second, so that no short press is lost; places in between are not needed.
void HapticsSession::heed(const ServoSample &sample)
{
    const bool isConnected = sample.reading.isConnected;
    if (!isConnected && mWasConnected) {
        endStroke();
        setForces(false); // who plugs it in again holds it differently
        mMustLetGo = true;
    }
    mWasConnected = isConnected;
    const bool isDown = isConnected && sample.reading.buttons != 0;
    if (!isDown) {
        if (isConnected) {
            mMustLetGo = false;
            if (mIsStroking)
                mLastOfStroke = sample;
        }
        endStroke();
    } else if (!mIsStroking && !mMustLetGo) {
        press(sample);
    }
}

void HapticsSession::press(const ServoSample &sample)
{
    mMustLetGo = true; // one stroke a press, also if it is refused
    if (!mStrokes || !mDocument || mStrokes->isDrawing())
        return;
    mLastOfStroke = sample;
    mIsStroking = mStrokes->press(eventAt(sample)) && mStrokes->isDrawing();
}

void HapticsSession::endStroke()
{
    // An undo in the midst of it may have ended it before.
    if (std::exchange(mIsStroking, false) && mStrokes && mDocument && mStrokes->isDrawing())
        mStrokes->release(eventAt(mLastOfStroke));
}

void HapticsSession::cancelStroke()
{
    mMustLetGo = true;
    if (std::exchange(mIsStroking, false) && mStrokes && mStrokes->isDrawing())
        mStrokes->cancel();
}

GroundEvent HapticsSession::eventAt(const ServoSample &sample) const
{
    const Workspace &workspace = mService.settings().workspace;
    const Point3 tool = workspace.toTerrain(sample.reading.position);
    const Rectangle domain = mDocument->tin().domain();
    const Point2 nearest{std::clamp(tool.x, domain.low.x, domain.high.x),
                         std::clamp(tool.y, domain.low.y, domain.high.y)};
    GroundEvent event;
    event.point = {tool.x, tool.y, mDocument->tin().heightAt(nearest)};
    event.isOnTerrain = domain.contains({tool.x, tool.y});
    event.metresPerPixel = workspace.toolRadius / PixelsPerRing;
    event.button = Qt::LeftButton;
    event.time = std::uint64_t(std::chrono::duration_cast<std::chrono::milliseconds>(sample.now).count());
    // A device without force cannot feel how deep it is: it draws as a mouse does.
    const Capabilities *const device = mService.capabilities();
    event.isPen = device && device->hasForce;
    if (event.isPen)
        event.pressure = std::clamp(sample.depth / FullDepth, LightTouch, 1.0);
    return event;
}

void HapticsSession::moveHand(const Point3 &place, bool isPressed)
{
    if (SimulatedDevice *const device = mService.simulated())
        device->moveTo(mService.settings().workspace.toHand(place), isPressed ? 1 : 0);
}

Point3 HapticsSession::toolPlace() const
{
    return mService.settings().workspace.toTerrain(mNow.reading.position);
}

} // namespace views
