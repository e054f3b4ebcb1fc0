// SPDX-License-Identifier: MIT
#include "lixel/report/staged_files.h"

#include <atomic>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace fs = std::filesystem;

namespace lixel {
namespace {

std::string wholeOf(const fs::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
}

// Which file system: files are renamed within one. 0 where there is none.
dev_t deviceOf(const fs::path& path)
{
    struct stat found
    {
    };
    return stat(path.c_str(), &found) == 0 ? found.st_dev : 0;
}

// Folders that were not there; without keep() they go again.
class NewFolders
{
public:
    ~NewFolders()
    {
        std::error_code stays;
        for (auto folder = made_.rbegin(); folder != made_.rend(); ++folder) fs::remove(*folder, stays);
    }

    void make(const fs::path& path)
    {
        std::error_code error;
        if (!fs::exists(path, error)) made_.push_back(path);
        makeFolder(path);
    }
    void keep() { made_.clear(); }

private:
    std::vector<fs::path> made_;
};

// Files that have taken their places, and those that stood there: what is not kept goes back.
class Replacement
{
public:
    ~Replacement()
    {
        for (const fs::path& path : placed_) unlink(path.c_str());
        for (const auto& [aside, place] : older_) std::rename(aside.c_str(), place.c_str());
    }

    void setAside(const fs::path& place)
    {
        const fs::path aside = temporaryName(place, "old");
        if (std::rename(place.c_str(), aside.c_str()) == 0) older_.push_back({aside, place});
        else if (errno != ENOENT) throw OutputError(place, errno);
    }
    void move(const fs::path& from, const fs::path& to)
    {
        if (std::rename(from.c_str(), to.c_str()) != 0) throw OutputError(to, errno);
        placed_.push_back(to);
    }
    void keep()
    {
        for (const auto& [aside, place] : older_) unlink(aside.c_str());
        older_.clear();
        placed_.clear();
    }

private:
    struct Older
    {
        fs::path aside, place;
    };
    std::vector<Older> older_;
    std::vector<fs::path> placed_;
};

// In the order of `moves`; what they replace goes in the opposite one. All of them are files, in the same file system as their places.
void replaceTogether(const std::vector<StagedFiles::Move>& moves)
{
    const Undisturbed quiet;
    Replacement replacement;
    for (auto move = moves.rbegin(); move != moves.rend(); ++move) replacement.setAside(move->to);
    for (const auto& [from, to] : moves) replacement.move(from, to);
    replacement.keep();
}

} // namespace

StagedFiles::~StagedFiles()
{
    std::error_code gone;
    for (const Move& move : moves_) fs::remove(move.from, gone);
}

fs::path StagedFiles::add(const fs::path& target)
{
    const OutputPlace place = placeOf(target);
    if (place.isInPlace) return target;
    const Move& move = moves_.emplace_back(Move{temporaryName(place.target, "staged"), place.target});
    removeWhenInterrupted(move.from);
    return move.from;
}

void StagedFiles::commit()
{
    replaceTogether(moves_);
    moves_.clear();
}

StagedFolder::StagedFolder(const fs::path& folder) : folder_(fs::absolute(folder))
{
    static std::atomic<unsigned> count{0};
    path_ = folder_ / (std::string(kStagedPrefix) + std::to_string(getpid()) + "-" + std::to_string(count++));
    makeFolder("");
}

StagedFolder::~StagedFolder()
{
    std::error_code stays;
    fs::remove_all(path_, stays);
}

void StagedFolder::makeFolder(const std::string& name)
{
    const fs::path made = name.empty() ? path_ : path_ / name;
    removeWhenInterrupted(made);
    lixel::makeFolder(made);
}

void StagedFolder::commit()
{
    std::vector<StagedFiles::Move> ofFolder, below;
    StagedFiles elsewhere; // a link may lead to another file system
    NewFolders folders;
    for (const auto& entry : fs::recursive_directory_iterator(path_)) {
        const fs::path path = folder_ / entry.path().lexically_relative(path_);
        if (entry.is_directory()) {
            folders.make(path);
            continue;
        }
        const OutputPlace place = placeOf(path);
        if (place.isInPlace) {
            writeFileAtomically(path, wholeOf(entry.path()));
            continue;
        }
        fs::path from = entry.path();
        if (deviceOf(place.target.parent_path()) != deviceOf(path_)) {
            from = elsewhere.add(path);
            writeFileAtomically(from, wholeOf(entry.path()));
        }
        (entry.path().parent_path() == path_ ? ofFolder : below).push_back({from, place.target});
    }
    below.insert(below.end(), ofFolder.begin(), ofFolder.end());
    replaceTogether(below);
    folders.keep();
}

} // namespace lixel
