// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/sceneimporter.h"

#include "model/base/bytes.h"
#include "model/io/failure.h"
#include "model/io/filebuffer.h"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <exception>
#include <future>
#include <mutex>
#include <new>
#include <string_view>
#include <thread>
#include <vector>

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <assimp/IOStream.hpp>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <assimp/scene.h>

namespace model::io {

namespace {

/// A file in memory.
class MemoryStream final : public Assimp::IOStream
{
public:
    explicit MemoryStream(Bytes bytes)
        : mBytes(std::move(bytes))
    {}

    std::size_t Read(void *buffer, std::size_t size, std::size_t count) override
    {
        const std::size_t whole = size == 0 ? 0 : std::min(count, (mBytes.size() - mPosition) / size);
        if (whole == 0)
            return 0;
        std::memcpy(buffer, mBytes.data() + mPosition, whole * size);
        mPosition += whole * size;
        return whole;
    }
    aiReturn Seek(std::size_t offset, aiOrigin origin) override
    {
        const std::size_t from = origin == aiOrigin_SET ? 0 : origin == aiOrigin_CUR ? mPosition : mBytes.size();
        const std::size_t target = from + offset; // a negative offset arrives as a huge one, and wraps as it should
        if (target > mBytes.size())
            return aiReturn_FAILURE;
        mPosition = target;
        return aiReturn_SUCCESS;
    }
    std::size_t Tell() const override { return mPosition; }
    std::size_t FileSize() const override { return mBytes.size(); }
    std::size_t Write(const void *, std::size_t, std::size_t) override { return 0; }
    void Flush() override {}

private:
    Bytes mBytes;
    std::size_t mPosition = 0;
};

/// Opens files of one folder and below, nothing else: a scene may name any path.
class FolderFiles final : public Assimp::IOSystem
{
public:
    FolderFiles(const QString &folder, const Progress &progress)
        : mFolder(QFileInfo(folder).canonicalFilePath() + QLatin1Char('/'))
        , mProgress(progress)
    {}

    /// A file that was opened has this in it.
    bool hasSeenClips() const { return mHasSeenClips; }

    bool Exists(const char *file) const override { return !allowedPath(file).isEmpty(); }
    char getOsSeparator() const override { return '/'; }
    Assimp::IOStream *Open(const char *file, const char *mode) override
    {
        const QString path = allowedPath(file);
        if (path.isEmpty() || std::strpbrk(mode, "wa+"))
            return nullptr;
        FileBuffer buffer;
        const auto bytes = buffer.load(path, mProgress);
        if (!bytes)
            return nullptr;
        mHasSeenClips = mHasSeenClips || bytes->find("<animation_clip") != std::string_view::npos;
        return new MemoryStream(Bytes(bytes->begin(), bytes->end()));
    }
    void Close(Assimp::IOStream *stream) override { delete stream; }

private:
    /// Where the file really is, through links and ".."; empty if that is elsewhere, or there is none.
    QString allowedPath(const char *file) const
    {
        const QString path = QFileInfo(QDir(mFolder), QString::fromUtf8(file)).canonicalFilePath();
        return path.startsWith(mFolder) && QFileInfo(path).isFile() ? path : QString();
    }

    QString mFolder;
    Progress mProgress;
    bool mHasSeenClips = false;
};

bool isSound(const aiMesh &mesh)
{
    if (!mesh.mVertices)
        return false;
    for (unsigned i = 0; i < mesh.mNumFaces; ++i)
        for (unsigned corner = 0; corner < mesh.mFaces[i].mNumIndices; ++corner)
            if (mesh.mFaces[i].mIndices[corner] >= mesh.mNumVertices)
                return false;
    for (unsigned i = 0; i < mesh.mNumBones; ++i)
        for (unsigned weight = 0; weight < mesh.mBones[i]->mNumWeights; ++weight)
            if (mesh.mBones[i]->mWeights[weight].mVertexId >= mesh.mNumVertices)
                return false;
    for (unsigned i = 0; i < mesh.mNumAnimMeshes; ++i)
        if (mesh.mAnimMeshes[i]->mVertices && mesh.mAnimMeshes[i]->mNumVertices != mesh.mNumVertices)
            return false;
    return true;
}

bool isSound(const aiNode &node, unsigned meshCount, int depth = 0)
{
    constexpr int MaxDepth = 1000; // a hierarchy deeper than this is an attack on the stack
    if (depth > MaxDepth)
        return false;
    for (unsigned i = 0; i < node.mNumMeshes; ++i)
        if (node.mMeshes[i] >= meshCount)
            return false;
    return std::all_of(node.mChildren, node.mChildren + node.mNumChildren,
                       [&](const aiNode *child) { return isSound(*child, meshCount, depth + 1); });
}

bool isSound(const aiScene &scene)
{
    return scene.mRootNode && isSound(*scene.mRootNode, scene.mNumMeshes) &&
           std::all_of(scene.mMeshes, scene.mMeshes + scene.mNumMeshes,
                       [](const aiMesh *mesh) { return isSound(*mesh); });
}

/// Keeps a thread until it has ended. At the end of the program that is waited for: what the importer works with would
/// be destroyed under its hands.
void leaveBehind(std::jthread thread)
{
    static std::mutex mutex;
    static std::vector<std::jthread> threads;
    const std::lock_guard lock(mutex);
    threads.push_back(std::move(thread));
}

} // namespace

ImportedScene::ImportedScene(std::unique_ptr<Assimp::Importer> importer, bool playsAllAnimations)
    : mImporter(std::move(importer))
    , mPlaysAllAnimations(playsAllAnimations)
{}
ImportedScene::ImportedScene(ImportedScene &&) noexcept = default;
ImportedScene::~ImportedScene() = default;

const aiScene &ImportedScene::scene() const
{
    return *mImporter->GetScene();
}

Result<ImportedScene> ImportedScene::readHere(const QString &path, const Progress &progress)
{
    const QFileInfo info(path);
    std::string message;
    try {
        auto importer = std::make_unique<Assimp::Importer>();
        auto *const files = new FolderFiles(info.absolutePath(), progress);
        importer->SetIOHandler(files); // which the importer owns
        // No post-processing: it would reorder or join vertices.
        const aiScene *const scene = importer->ReadFile(info.fileName().toStdString(), 0);
        const bool isCollada = info.suffix().compare(QLatin1String("dae"), Qt::CaseInsensitive) == 0;
        if (scene && isSound(*scene))
            return ImportedScene(std::move(importer), isCollada && !files->hasSeenClips());
        message = scene ? QT_TRANSLATE_NOOP("ErrorText", "the scene contradicts itself") : importer->GetErrorString();
    } catch (const std::bad_alloc &) {
        throw;
    } catch (const std::exception &exception) {
        message = exception.what();
    } catch (...) {
        message = QT_TRANSLATE_NOOP("ErrorText", "for an unknown reason");
    }
    if (progress.isCancelled())
        return fail(ErrorCode::Cancelled);
    return failIn(path, ErrorCode::ImporterFailed, message);
}

Result<ImportedScene> ImportedScene::read(const QString &path, const Progress &progress)
{
    QFile file(path);
    if (const auto opened = openFile(file); !opened)
        return fail(opened.error());
    file.close();

    // The importer does not look for a cancel (it reports progress at its begin and end alone), so it works in a thread
    // that can be left to itself.
    std::packaged_task<Result<ImportedScene>()> import([path, progress] { return readHere(path, progress); });
    std::future<Result<ImportedScene>> scene = import.get_future();
    std::jthread thread(std::move(import));
    constexpr std::chrono::milliseconds Poll(10);
    while (scene.wait_for(Poll) != std::future_status::ready)
        if (progress.isCancelled()) {
            leaveBehind(std::move(thread));
            return fail(ErrorCode::Cancelled);
        }
    return scene.get();
}

} // namespace model::io
