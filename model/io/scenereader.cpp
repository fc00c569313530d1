// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/scenereader.h"

#include "model/base/outofmemory.h"
#include "model/base/parallel.h"
#include "model/io/failure.h"
#include "model/io/firsterror.h"
#include "model/io/positionmemory.h"
#include "model/io/sceneclip.h"
#include "model/io/sceneimporter.h"
#include "model/io/weldtrajectories.h"
#include "model/io/workspaces.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <span>
#include <string_view>

#include <QStringList>

#include <assimp/anim.h>
#include <assimp/scene.h>

namespace model::io {

namespace {

/// One of the keys of a node around a time, and how far it is to the next.
struct KeyPosition
{
    unsigned first = 0, second = 0;
    float fraction = 0;
};

template <class Key>
KeyPosition findKeys(const Key *keys, unsigned count, double time)
{
    const Key *const after =
        std::upper_bound(keys, keys + count, time, [](double t, const Key &key) { return t < key.mTime; });
    const auto next = unsigned(after - keys);
    if (next == 0)
        return {0, 0, 0};
    if (next == count)
        return {count - 1, count - 1, 0};
    return {next - 1, next, float((time - keys[next - 1].mTime) / (keys[next].mTime - keys[next - 1].mTime))};
}

aiVector3D valueAt(const aiVectorKey *keys, unsigned count, double time, aiVector3D otherwise)
{
    if (count == 0)
        return otherwise;
    const KeyPosition at = findKeys(keys, count, time);
    const aiVector3D &a = keys[at.first].mValue, &b = keys[at.second].mValue;
    return a + (b - a) * at.fraction;
}

aiQuaternion valueAt(const aiQuatKey *keys, unsigned count, double time, aiQuaternion otherwise)
{
    if (count == 0)
        return otherwise;
    const KeyPosition at = findKeys(keys, count, time);
    aiQuaternion result;
    aiQuaternion::Interpolate(result, keys[at.first].mValue, keys[at.second].mValue, at.fraction);
    return result.Normalize();
}

/// The transform of a node at a time, in its parent.
aiMatrix4x4 localTransform(const aiNode &node, const aiNodeAnim *channel, double time)
{
    if (!channel)
        return node.mTransformation;
    aiVector3D scaling, position;
    aiQuaternion rotation;
    node.mTransformation.Decompose(scaling, rotation, position);
    scaling = valueAt(channel->mScalingKeys, channel->mNumScalingKeys, time, scaling);
    rotation = valueAt(channel->mRotationKeys, channel->mNumRotationKeys, time, rotation);
    position = valueAt(channel->mPositionKeys, channel->mNumPositionKeys, time, position);
    // Scales first, then turns; assimp's own constructor of these three does it the other way round.
    aiMatrix4x4 scale;
    aiMatrix4x4::Scaling(scaling, scale);
    aiMatrix4x4 result = aiMatrix4x4(rotation.GetMatrix()) * scale;
    result.a4 = position.x;
    result.b4 = position.y;
    result.c4 = position.z;
    return result;
}

/// A mesh at a node, as a part of the whole.
struct Part
{
    const aiMesh *mesh;
    std::size_t node;
    std::size_t firstVertex;
    const aiMeshMorphAnim *morph; // may be null
    std::vector<std::size_t> boneNodes;
    /// Sum of the weights of each vertex; empty without bones.
    std::vector<float> weightSums;
};

/// The scene laid out for baking: nodes with parents first, parts in the order of the nodes.
class Baker
{
public:
    Baker(const aiScene &scene, const SceneClip &clip)
        : mClip(clip)
    {
        std::map<std::string_view, const aiNodeAnim *> channels;
        for (const aiAnimation *animation : clip.animations())
            for (unsigned i = 0; i < animation->mNumChannels; ++i)
                channels.emplace(animation->mChannels[i]->mNodeName.C_Str(), animation->mChannels[i]);
        addNode(*scene.mRootNode, NoParent, channels);
        for (std::size_t node = 0; node < mNodes.size(); ++node)
            for (unsigned i = 0; i < mNodes[node].node->mNumMeshes; ++i)
                addPart(*scene.mMeshes[mNodes[node].node->mMeshes[i]], node);
    }

    Connectivity &connectivity() { return mConnectivity; }

    struct Workspace
    {
        std::vector<aiMatrix4x4> globals;
        std::vector<aiVector3D> morphed;
        std::vector<float> weights;
    };

    /// Any thread. \param time  in ticks; \param out  #V, written
    void bake(double time, std::span<Vec3f> out, Workspace &workspace) const
    {
        std::vector<aiMatrix4x4> &globals = workspace.globals;
        globals.resize(mNodes.size());
        for (std::size_t i = 0; i < mNodes.size(); ++i) {
            const aiMatrix4x4 local = localTransform(*mNodes[i].node, mNodes[i].channel, time);
            globals[i] = mNodes[i].parent == NoParent ? local : globals[mNodes[i].parent] * local;
        }
        for (const Part &part : mParts) {
            const std::span<Vec3f> target = out.subspan(part.firstVertex, part.mesh->mNumVertices);
            const aiVector3D *const vertices = morph(part, time, workspace);
            if (part.boneNodes.empty())
                transform(vertices, globals[part.node], target);
            else
                skin(part, vertices, globals, target);
        }
    }

private:
    static constexpr std::size_t NoParent = ~std::size_t(0);

    struct Node
    {
        const aiNode *node;
        std::size_t parent;
        const aiNodeAnim *channel; // null: does not move in its parent
    };

    void addNode(const aiNode &node, std::size_t parent, const std::map<std::string_view, const aiNodeAnim *> &channels)
    {
        const auto channel = channels.find(node.mName.C_Str());
        const std::size_t index = mNodes.size();
        mNodes.push_back({&node, parent, channel == channels.end() ? nullptr : channel->second});
        // Names need not be unique: glTF often calls a mesh's node and its bone the same. A bone has no mesh.
        const auto [named, isNew] = mNodeByName.emplace(node.mName.C_Str(), index);
        if (!isNew && mNodes[named->second].node->mNumMeshes && !node.mNumMeshes)
            named->second = index;
        for (unsigned i = 0; i < node.mNumChildren; ++i)
            addNode(*node.mChildren[i], index, channels);
    }

    void addPart(const aiMesh &mesh, std::size_t node)
    {
        const std::size_t facesBefore = mConnectivity.triangles.size();
        for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
            const aiFace &face = mesh.mFaces[i];
            const auto index = [&](unsigned corner) { return mConnectivity.vertexCount + face.mIndices[corner]; };
            for (unsigned corner = 2; corner < face.mNumIndices; ++corner)
                mConnectivity.triangles.push_back({index(0), index(corner - 1), index(corner)});
        }
        if (mConnectivity.triangles.size() == facesBefore)
            return; // points and lines only

        Part part{&mesh, node, mConnectivity.vertexCount, morphChannelOf(mesh, *mNodes[node].node), {}, {}};
        for (unsigned i = 0; i < mesh.mNumBones; ++i) {
            const auto bone = mNodeByName.find(mesh.mBones[i]->mName.C_Str());
            part.boneNodes.push_back(bone == mNodeByName.end() ? node : bone->second);
        }
        if (mesh.mNumBones) {
            part.weightSums.resize(mesh.mNumVertices, 0);
            for (unsigned i = 0; i < mesh.mNumBones; ++i)
                for (unsigned w = 0; w < mesh.mBones[i]->mNumWeights; ++w)
                    part.weightSums[mesh.mBones[i]->mWeights[w].mVertexId] += mesh.mBones[i]->mWeights[w].mWeight;
        }
        mConnectivity.vertexCount += mesh.mNumVertices;
        mParts.push_back(std::move(part));
    }

    /// glTF names the node, FBX the mesh, with "*" and a number behind.
    const aiMeshMorphAnim *morphChannelOf(const aiMesh &mesh, const aiNode &node) const
    {
        if (!mesh.mNumAnimMeshes)
            return nullptr;
        const auto bare = [](const aiString &name) {
            const std::string_view text = name.C_Str();
            return text.substr(0, text.rfind('*'));
        };
        for (const aiAnimation *animation : mClip.animations())
            for (unsigned i = 0; i < animation->mNumMorphMeshChannels; ++i) {
                const aiMeshMorphAnim *const channel = animation->mMorphMeshChannels[i];
                if (channel->mNumKeys &&
                    (bare(channel->mName) == bare(node.mName) || bare(channel->mName) == bare(mesh.mName)))
                    return channel;
            }
        return nullptr;
    }

    static void morphWeights(const Part &part, double time, std::vector<float> &weights)
    {
        const unsigned count = part.mesh->mNumAnimMeshes;
        weights.assign(count, 0);
        if (!part.morph) {
            for (unsigned i = 0; i < count; ++i)
                weights[i] = part.mesh->mAnimMeshes[i]->mWeight;
            return;
        }
        const KeyPosition at = findKeys(part.morph->mKeys, part.morph->mNumKeys, time);
        const auto add = [&](const aiMeshMorphKey &key, float share) {
            for (unsigned i = 0; i < key.mNumValuesAndWeights; ++i)
                if (key.mValues[i] < count)
                    weights[key.mValues[i]] += share * float(key.mWeights[i]);
        };
        add(part.morph->mKeys[at.first], 1 - at.fraction);
        if (at.fraction > 0)
            add(part.morph->mKeys[at.second], at.fraction);
    }

    /// The vertices of a part with its morph targets applied. Targets hold whole positions, not differences.
    static const aiVector3D *morph(const Part &part, double time, Workspace &workspace)
    {
        const aiMesh &mesh = *part.mesh;
        if (!mesh.mNumAnimMeshes)
            return mesh.mVertices;
        morphWeights(part, time, workspace.weights);
        workspace.morphed.assign(mesh.mVertices, mesh.mVertices + mesh.mNumVertices);
        for (unsigned target = 0; target < mesh.mNumAnimMeshes; ++target) {
            const aiVector3D *const positions = mesh.mAnimMeshes[target]->mVertices;
            const float weight = workspace.weights[target];
            if (!positions || weight == 0)
                continue;
            for (unsigned i = 0; i < mesh.mNumVertices; ++i)
                workspace.morphed[i] += (positions[i] - mesh.mVertices[i]) * weight;
        }
        return workspace.morphed.data();
    }

    static void transform(const aiVector3D *vertices, const aiMatrix4x4 &matrix, std::span<Vec3f> out)
    {
        for (std::size_t i = 0; i < out.size(); ++i) {
            const aiVector3D p = matrix * vertices[i];
            out[i] = {p.x, p.y, p.z};
        }
    }

    /// Linear blend skinning. The mesh's own node does not matter to it, except to vertices without any bone.
    static void skin(const Part &part, const aiVector3D *vertices, const std::vector<aiMatrix4x4> &globals,
                     std::span<Vec3f> out)
    {
        std::fill(out.begin(), out.end(), Vec3f{});
        for (unsigned bone = 0; bone < part.mesh->mNumBones; ++bone) {
            const aiBone &b = *part.mesh->mBones[bone];
            const aiMatrix4x4 matrix = globals[part.boneNodes[bone]] * b.mOffsetMatrix;
            for (unsigned w = 0; w < b.mNumWeights; ++w) {
                const unsigned vertex = b.mWeights[w].mVertexId;
                if (!(part.weightSums[vertex] > 0))
                    continue;
                const aiVector3D p = matrix * vertices[vertex];
                out[vertex] = out[vertex] + Vec3f{p.x, p.y, p.z} * (b.mWeights[w].mWeight / part.weightSums[vertex]);
            }
        }
        for (std::size_t i = 0; i < out.size(); ++i)
            if (!(part.weightSums[i] > 0))
                transform(vertices + i, globals[part.node], out.subspan(i, 1));
    }

    const SceneClip &mClip;
    std::vector<Node> mNodes;
    std::map<std::string_view, std::size_t> mNodeByName;
    std::vector<Part> mParts;
    Connectivity mConnectivity;
};

} // namespace

QStringList sceneEndings()
{
    return {QStringLiteral("gltf"), QStringLiteral("glb"), QStringLiteral("fbx"), QStringLiteral("dae")};
}

Result<std::shared_ptr<const Sequence>> readScene(const QString &path, double frameRate, int animationIndex,
                                                  std::string name, const Progress &progress)
{
    const Result<ImportedScene> imported = ImportedScene::read(path, progress);
    if (!imported)
        return fail(imported.error());
    const aiScene &scene = imported->scene();
    const std::span<aiAnimation *const> animations(scene.mAnimations, scene.mNumAnimations);
    const int choices = imported->playsAllAnimations() ? 1 : std::max(1, int(animations.size()));
    if (animationIndex < 0 || animationIndex >= choices)
        return failIn(path, ErrorCode::BadSetting, QT_TRANSLATE_NOOP("ErrorText", "The number of the animation"),
                      std::to_string(animationIndex), "0.." + std::to_string(choices - 1));
    const bool isAll = imported->playsAllAnimations() || animations.empty();
    const auto chosen = isAll ? animations : animations.subspan(std::size_t(animationIndex), 1);
    const SceneClip clip({chosen.begin(), chosen.end()});

    Baker baker(scene, clip);
    const std::size_t vertexCount = baker.connectivity().vertexCount;
    if (vertexCount == 0)
        return failIn(path, ErrorCode::NoAnimation, QT_TRANSLATE_NOOP("ErrorText", "there is no mesh in it"));
    const double rate = frameRate > 0 ? frameRate : clip.keyRate();
    const double frameCount = clip.frameCount(rate);
    constexpr double MaxFrames = 1e6;
    if (!(frameCount <= MaxFrames))
        return failIn(path, ErrorCode::LimitExceeded, QT_TRANSLATE_NOOP("ErrorText", "the number of frames"),
                      std::to_string(frameCount), std::to_string(int(MaxFrames)));
    Result<std::vector<Vec3f>> positions = positionMemory(vertexCount, std::uint64_t(frameCount));
    if (!positions)
        return failIn(path, std::move(positions.error()));

    Workspaces<Baker::Workspace> workspaces;
    FirstError firstError;
    std::atomic<std::size_t> done = 0;
    parallelFor(std::size_t(frameCount), [&](std::size_t frame) {
        if (firstError.isBefore(frame) || progress.isCancelled())
            return;
        const std::span<Vec3f> out = std::span(*positions).subspan(frame * vertexCount, vertexCount);
        const auto baked = catchBadAlloc([&]() -> Result<void> {
            baker.bake(clip.timeOf(double(frame), rate), out, *workspaces.take());
            if (const auto bad = std::find_if_not(out.begin(), out.end(), isFinite); bad != out.end())
                return fail(ErrorCode::NonFinite, "vertex " + std::to_string(bad - out.begin()));
            return {};
        });
        if (!baked)
            return firstError.set(frame, baked.error());
        progress.report(double(++done) / frameCount);
    });
    if (progress.isCancelled())
        return fail(ErrorCode::Cancelled);
    if (firstError)
        return failIn(path, firstError.take());
    if (auto welded = weldTrajectories(baker.connectivity(), *positions, progress); !welded)
        return fail(std::move(welded.error()));
    return std::make_shared<const Sequence>(std::move(baker.connectivity()), std::move(*positions), rate,
                                            std::move(name));
}

} // namespace model::io
