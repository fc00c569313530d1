// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/animation/metrics.h"
#include "tests/bench/comparison/contender.h"
#include "tests/bench/comparison/stopwatch.h"

#include <draco/compression/decode.h>
#include <draco/compression/expert_encode.h>

#include <cmath>
#include <map>
#include <stdexcept>

namespace bench {

using namespace model;

namespace {

constexpr int LeastBits = 4, MostBits = 20;

/// One frame as Draco takes it.
class DracoFrame
{
public:
    explicit DracoFrame(const Connectivity &connectivity)
        : mCount(connectivity.vertexCount)
    {
        mMesh.SetNumFaces(connectivity.triangles.size());
        for (std::uint32_t t = 0; t < connectivity.triangles.size(); ++t) {
            const Triangle &from = connectivity.triangles[t];
            draco::Mesh::Face face;
            for (unsigned i = 0; i < 3; ++i)
                face[i] = draco::PointIndex(from[i]);
            mMesh.SetFace(draco::FaceIndex(t), face);
        }
        mMesh.set_num_points(mCount);
        draco::GeometryAttribute position;
        position.Init(draco::GeometryAttribute::POSITION, nullptr, 3, draco::DT_FLOAT32, false, sizeof(Vec3f), 0);
        mPosition = mMesh.AddAttribute(position, true, mCount);
    }

    void setPositions(std::span<const Vec3f> positions)
    {
        for (std::uint32_t v = 0; v < mCount; ++v)
            mMesh.attribute(mPosition)->SetAttributeValue(draco::AttributeValueIndex(v), &positions[v]);
    }
    /// As small as Draco makes it: EdgeBreaker, speed 0.
    void encode(int bits, draco::EncoderBuffer &out) const
    {
        draco::ExpertEncoder encoder(mMesh);
        encoder.SetSpeedOptions(0, 0);
        encoder.SetEncodingMethod(draco::MESH_EDGEBREAKER_ENCODING);
        encoder.SetAttributeQuantization(mPosition, bits);
        if (const draco::Status status = encoder.EncodeToBuffer(&out); !status.ok())
            throw std::runtime_error(status.error_msg_string());
    }

private:
    draco::Mesh mMesh;
    std::uint32_t mCount;
    int mPosition = 0;
};

std::unique_ptr<draco::Mesh> decoded(const char *data, std::size_t size)
{
    draco::DecoderBuffer buffer;
    buffer.Init(data, size);
    auto mesh = draco::Decoder().DecodeMeshFromBuffer(&buffer);
    if (!mesh.ok())
        throw std::runtime_error(mesh.status().error_msg_string());
    return std::move(mesh).value();
}

/// Which vertex of the input each decoded point is: Draco keeps no order, but has the same one for the same triangles
/// wherever they lie. So each vertex is put where its number says.
std::vector<std::uint32_t> pointOrder(const Subject &subject)
{
    constexpr int ExactBits = 26;
    std::vector<Vec3f> numbers;
    for (std::uint32_t v = 0; v < subject.animation->vertexCount(); ++v)
        numbers.push_back({float(v), 0, 0});
    DracoFrame frame(subject.animation->connectivity());
    frame.setPositions(numbers);
    draco::EncoderBuffer buffer;
    frame.encode(ExactBits, buffer);
    const auto mesh = decoded(buffer.data(), buffer.size());
    const draco::PointAttribute *from = mesh->GetNamedAttribute(draco::GeometryAttribute::POSITION);
    std::vector<std::uint32_t> order;
    for (std::uint32_t p = 0; p < mesh->num_points(); ++p) {
        Vec3f number;
        from->GetMappedValue(draco::PointIndex(p), &number);
        order.push_back(std::uint32_t(std::lround(number.x)));
    }
    return order;
}

/// Every frame a mesh of its own, as Draco is made for: its connectivity in each of them.
class Draco final : public Contender
{
public:
    std::vector<Measurement> reach(const Subject &subject, double percent) override
    {
        if (mSubject != subject.name) {
            mSubject = subject.name;
            mOrder = pointOrder(subject);
            mKnown.clear();
        }
        // The error falls by halves.
        int least = LeastBits, most = MostBits;
        while (least < most) {
            const int middle = (least + most) / 2;
            if (at(subject, middle).kgErrorPercent <= percent)
                most = middle;
            else
                least = middle + 1;
        }
        Measurement row = at(subject, least);
        if (row.kgErrorPercent > percent)
            return {};
        // Positions of one bit are next to nothing: what is left is connectivity. The second row leaves it out of all
        // frames but one: smaller than any file that Draco could write.
        DracoFrame frame(subject.animation->connectivity());
        frame.setPositions(subject.animation->frameView(0));
        draco::EncoderBuffer buffer;
        frame.encode(1, buffer);
        Measurement once = row;
        once.codec = "draco, connectivity once";
        once.bytes -= std::min<std::uint64_t>(once.bytes, (subject.animation->frameCount() - 1) * buffer.size());
        once.encodeSeconds = once.decodeSeconds = NotMeasured;
        return {row, once};
    }

private:
    const Measurement &at(const Subject &subject, int bits)
    {
        const auto [entry, isNew] = mKnown.try_emplace(bits);
        Measurement &row = entry->second;
        if (!isNew)
            return row;
        row.codec = "draco";
        row.setting = "bits=" + std::to_string(bits);
        const Sequence &animation = *subject.animation;
        DracoFrame frame(animation.connectivity());
        std::vector<draco::EncoderBuffer> files;
        row.encodeSeconds = secondsOf([&] {
            files = std::vector<draco::EncoderBuffer>(animation.frameCount());
            for (std::uint32_t f = 0; f < animation.frameCount(); ++f) {
                frame.setPositions(animation.frameView(f));
                frame.encode(bits, files[f]);
            }
        });
        const std::size_t count = animation.vertexCount();
        std::vector<Vec3f> positions(animation.allPositions().begin(), animation.allPositions().end());
        row.decodeSeconds = secondsOf([&] {
            for (std::uint32_t f = 0; f < animation.frameCount(); ++f) {
                const auto mesh = decoded(files[f].data(), files[f].size());
                if (mesh->num_points() != mOrder.size())
                    throw std::runtime_error("draco: other points than in the first frame");
                const draco::PointAttribute *from = mesh->GetNamedAttribute(draco::GeometryAttribute::POSITION);
                for (std::uint32_t p = 0; p < mOrder.size(); ++p)
                    from->GetMappedValue(draco::PointIndex(p), &positions[f * count + mOrder[p]]);
            }
        });
        for (const draco::EncoderBuffer &file : files)
            row.bytes += file.size();
        const Sequence result(animation.connectivity(), std::move(positions));
        row.kgErrorPercent = compareAnimations(animation, result)->kgErrorPercent;
        return row;
    }

    std::string mSubject;
    std::vector<std::uint32_t> mOrder;
    std::map<int, Measurement> mKnown; ///< by bits
};

} // namespace

std::unique_ptr<Contender> makeDraco()
{
    return std::make_unique<Draco>();
}

} // namespace bench
