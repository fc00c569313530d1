// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/haptics/hid/pidlayout.h"

#include <algorithm>
#include <cmath>

namespace model::haptics {

namespace {

const HidField *anyFieldIn(std::span<const HidField> fields, HidField::Kind kind, HidUsage collection)
{
    for (const HidField &field : fields)
        if (field.kind == kind && field.isIn(collection))
            return &field;
    return nullptr;
}

std::size_t indexOf(const HidField &field, HidUsage usage)
{
    return std::size_t(std::find(field.usages.begin(), field.usages.end(), usage) - field.usages.begin());
}

} // namespace

bool hasReport(std::span<const HidField> fields, HidField::Kind kind, HidUsage collection)
{
    return anyFieldIn(fields, kind, collection) != nullptr;
}

const HidField *fieldOf(std::span<const HidField> fields, HidField::Kind kind, HidUsage collection, HidUsage usage)
{
    for (const HidField &field : fields)
        if (field.kind == kind && field.isIn(collection) && indexOf(field, usage) < field.usages.size())
            return &field;
    return nullptr;
}

bool hasConstantForce(std::span<const HidField> fields)
{
    using enum HidField::Kind;
    return fieldOf(fields, Output, pid::SetConstantForce, pid::Magnitude) &&
           hasReport(fields, Output, pid::SetEffect) && hasReport(fields, Output, pid::EffectOperation) &&
           hasReport(fields, Feature, pid::CreateNewEffect) &&
           fieldOf(fields, Feature, pid::BlockLoad, pid::BlockIndex);
}

PidReport::PidReport(std::span<const HidField> fields, HidField::Kind kind, HidUsage collection)
    : mFields(fields)
    , mKind(kind)
    , mCollection(collection)
    , mReportId(anyFieldIn(fields, kind, collection)->reportId)
    , mBytes(reportSize(fields, kind, mReportId))
{
    mBytes[0] = mReportId;
}

template <class Visit>
void PidReport::forEachField(Visit visit)
{
    for (const HidField &field : mFields)
        if (field.kind == mKind && field.reportId == mReportId && field.isIn(mCollection) && !field.isConstant)
            visit(field);
}

PidReport &PidReport::set(HidUsage usage, std::int64_t value)
{
    forEachField([&](const HidField &field) {
        if (const std::size_t i = indexOf(field, usage); i < field.usages.size() && !field.isArray)
            setValueIn(mBytes, field,
                       std::int32_t(std::clamp<std::int64_t>(value, std::min(field.least, field.most),
                                                             std::max(field.least, field.most))),
                       std::uint32_t(i));
    });
    return *this;
}

PidReport &PidReport::setShare(HidUsage usage, double share)
{
    forEachField([&](const HidField &field) {
        if (const std::size_t i = indexOf(field, usage); i < field.usages.size() && !field.isArray) {
            const double end = share < 0 ? -double(field.least) : double(field.most);
            set(usage, std::llround(std::clamp(share, -1.0, 1.0) * end));
        }
    });
    return *this;
}

PidReport &PidReport::choose(HidUsage group, HidUsage choice)
{
    forEachField([&](const HidField &field) {
        const std::size_t i = indexOf(field, choice);
        if (!field.isIn(group) || i == field.usages.size())
            return;
        if (field.isArray)
            setValueIn(mBytes, field, field.least + std::int32_t(i));
        else
            setValueIn(mBytes, field, 1, std::uint32_t(i));
    });
    return *this;
}

PidReport &PidReport::setAngle(HidUsage group, double turns)
{
    bool isFirst = true;
    forEachField([&](const HidField &field) {
        if (!isFirst || !field.isIn(group))
            return;
        isFirst = false;
        const double whole = double(field.most) - field.least + 1;
        const double value = std::floor((turns - std::floor(turns)) * whole) + field.least;
        setValueIn(mBytes, field, std::int32_t(std::min(value, double(field.most))));
    });
    return *this;
}

} // namespace model::haptics
