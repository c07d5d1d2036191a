// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/PictureSource.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <utility>

#include <dlfcn.h>
#include <fcntl.h>
#include <unistd.h>

#include "core/tracking/PictureLibrary.h"

namespace core::tracking {
namespace {

namespace fs = std::filesystem;

constexpr const char* kLibraryFile = "../lib/cusp/cusp_pictures.so";  ///< from the folder of the program
constexpr std::size_t kMostImages = 100'000;
constexpr std::array<std::string_view, 7> kImageEndings{".png", ".jpg", ".jpeg", ".bmp", ".pgm", ".tif", ".tiff"};

/// Loads the library once. Returns null if it is missing or cannot be loaded.
const PictureLibrary* library()
{
    static const PictureLibrary* const loaded = []() -> const PictureLibrary* {
        std::error_code ignored;
        const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
        void* const handle = dlopen((program.parent_path() / kLibraryFile).c_str(), RTLD_NOW | RTLD_LOCAL);
        if (handle == nullptr)
            return nullptr;
        const auto entry = reinterpret_cast<Entry>(dlsym(handle, kEntry));
        return entry == nullptr ? nullptr : entry();
    }();
    return loaded;
}

tl::unexpected<Error> noLibrary()
{
    return unexpected(
        ErrorCode::FileUnreadable,
        LocalizableText{"Cusp cannot read pictures: its file %1 or a library of OpenCV is missing. Install Cusp "
                        "again. The mouse works without it.",
                        {noted("lib/cusp/cusp_pictures.so")}});
}

std::string deviceOf(int number)
{
    return "/dev/video" + std::to_string(number);
}

class LiveSource final : public PictureSource
{
public:
    LiveSource(std::unique_ptr<PictureReader> reader, int number) : m_reader(std::move(reader)), m_number(number) {}

    Result<bool> next(Picture& picture) override
    {
        if (m_reader->read(picture))
            return true;
        return unexpected(ErrorCode::ConnectionLost,
                          LocalizableText{"Camera %1 gives no more pictures. Check that it is plugged in.",
                                          {noted(std::to_string(m_number))}});
    }
    bool isLive() const override { return true; }

private:
    std::unique_ptr<PictureReader> m_reader;
    int m_number;
};

class VideoSource final : public PictureSource
{
public:
    VideoSource(std::unique_ptr<PictureReader> reader, std::string name)
        : m_reader(std::move(reader)), m_name(std::move(name))
    {}

    Result<bool> next(Picture& picture) override
    {
        if (!m_reader->read(picture)) {
            if (isCutOff())
                return unexpected(ErrorCode::FileTruncated,
                                  "The video " + m_name + " ends before its time: it is cut off or damaged.");
            return false;
        }
        // Some files have no times, or times that do not increase.
        if (!(picture.timeS >= 0.0 && picture.timeS < kLongestS))
            picture.timeS = m_lastS + kUsualStepS;
        picture.timeS = m_pictures == 0.0 ? picture.timeS : std::max(picture.timeS, m_lastS + kLeastStepS);
        m_lastS = picture.timeS;
        ++m_pictures;
        return true;
    }
    bool isLive() const override { return false; }

private:
    /// Returns whether the video ends too early. The length in a header may be an estimate, and so may the times of the
    /// pictures.
    bool isCutOff() const
    {
        constexpr double kWholeShare = 0.9;
        constexpr double kLeastMissing = 3.0;
        const PictureReader::Length whole = m_reader->length();
        return m_pictures + kLeastMissing < kWholeShare * whole.pictures && m_lastS < kWholeShare * whole.seconds;
    }

    static constexpr double kLeastStepS = 0.001;
    static constexpr double kUsualStepS = 1.0 / 30.0;
    static constexpr double kLongestS = 1e6;
    std::unique_ptr<PictureReader> m_reader;
    std::string m_name;
    double m_lastS = 0.0;
    double m_pictures = 0.0;
};

class FolderSource final : public PictureSource
{
public:
    FolderSource(const PictureLibrary& from, std::vector<fs::path> files) : m_library(from), m_files(std::move(files))
    {}

    Result<bool> next(Picture& picture) override
    {
        if (m_next == m_files.size())
            return false;
        const fs::path& file = m_files[m_next];
        const double timeS = static_cast<double>(m_next) * kStepS;
        ++m_next;
        picture.name = file.filename().string();
        if (!m_library.readImage(file.c_str(), picture))
            return unexpected(ErrorCode::WrongKind,
                              LocalizableText{"%1 is no image, or is cut off.", {noted(picture.name)}});
        picture.timeS = timeS;
        return true;
    }
    bool isLive() const override { return false; }

private:
    static constexpr double kStepS = 1.0 / 30.0;  ///< as for a camera
    const PictureLibrary& m_library;
    std::vector<fs::path> m_files;
    std::size_t m_next = 0;
};

bool isImage(const fs::path& file)
{
    std::string ending = file.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return std::find(kImageEndings.begin(), kImageEndings.end(), ending) != kImageEndings.end();
}

/// Returns whether a file begins as text. FFmpeg would render it as the screen of a terminal, or follow the links of a
/// playlist.
bool isText(const std::string& path)
{
    std::error_code ignored;
    if (!fs::is_regular_file(path, ignored))
        return false;  // a pipe cannot be read twice
    std::ifstream file(path, std::ios::binary);
    std::array<char, 1024> head{};
    file.read(head.data(), head.size());
    const std::string_view begin(head.data(), static_cast<std::size_t>(file.gcount()));
    return std::all_of(begin.begin(), begin.end(), [](char c) {
        const auto code = static_cast<unsigned char>(c);
        return code >= 0x20 || code == '\n' || code == '\r' || code == '\t';
    });
}

}  // namespace

std::vector<CameraInfo> cameras()
{
    std::vector<CameraInfo> found;
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator("/sys/class/video4linux", ignored)) {
        const std::string file = entry.path().filename().string();
        constexpr std::string_view kBegin = "video";
        if (file.rfind(kBegin, 0) != 0)
            continue;
        CameraInfo camera;
        const char* const end = file.data() + file.size();
        const auto [rest, code] = std::from_chars(file.data() + kBegin.size(), end, camera.number);
        // A camera may have several devices, some of which return no pictures.
        int index = 0;
        std::ifstream(entry.path() / "index") >> index;
        if (code != std::errc{} || rest != end || index != 0)
            continue;
        std::ifstream name(entry.path() / "name");
        std::getline(name, camera.name);
        found.push_back(camera);
    }
    std::sort(found.begin(), found.end(), [](const CameraInfo& a, const CameraInfo& b) { return a.number < b.number; });
    return found;
}

Result<std::unique_ptr<PictureSource>> openCamera(int number, const CameraWish& wish)
{
    const std::string device = deviceOf(number);
    std::error_code ignored;
    if (!fs::exists(device, ignored))
        return unexpected(ErrorCode::FileMissing,
                          LocalizableText{"There is no camera %1. Plug in a camera, or choose another one.",
                                          {noted(std::to_string(number))}});
    if (access(device.c_str(), R_OK | W_OK) != 0)
        return unexpected(
            ErrorCode::NotAllowed,
            LocalizableText{"You have no permission to use camera %1. An administrator of this computer can add you "
                            "to the group \"video\".",
                            {noted(std::to_string(number))}});
    const PictureLibrary* const from = library();
    if (from == nullptr)
        return noLibrary();
    std::unique_ptr<PictureReader> reader(from->openCamera(number, wish.width, wish.height, wish.hz));
    if (!reader)
        return unexpected(
            ErrorCode::Busy,
            LocalizableText{"Camera %1 gives no pictures. Close other programs that use it, or choose another one.",
                            {noted(std::to_string(number))}});
    return std::make_unique<LiveSource>(std::move(reader), number);
}

Result<std::unique_ptr<PictureSource>> openVideo(const std::string& path)
{
    std::error_code ignored;
    if (!fs::exists(path, ignored))
        return unexpected(ErrorCode::FileMissing, LocalizableText{"There is no file %1.", {noted(path)}});
    if (fs::is_directory(path, ignored))
        return unexpected(ErrorCode::WrongKind, LocalizableText{"%1 is a folder, not a video.", {noted(path)}});
    if (access(path.c_str(), R_OK) != 0)
        return unexpected(ErrorCode::FileUnreadable, LocalizableText{"The file %1 cannot be read.", {noted(path)}});
    const PictureLibrary* const from = library();
    if (from == nullptr)
        return noLibrary();
    std::unique_ptr<PictureReader> reader(isText(path) ? nullptr : from->openVideo(path.c_str()));
    if (!reader)
        return unexpected(ErrorCode::WrongKind,
                          LocalizableText{"%1 is no video, or of a kind that cannot be read here.", {noted(path)}});
    return std::make_unique<VideoSource>(std::move(reader), fs::path(path).filename().string());
}

Result<std::unique_ptr<PictureSource>> openFolder(const std::string& path)
{
    std::error_code error;
    if (!fs::is_directory(path, error))
        return unexpected(ErrorCode::FileMissing, LocalizableText{"There is no folder %1.", {noted(path)}});
    std::vector<fs::path> files;
    for (fs::directory_iterator entry(path, error), end; !error && entry != end; entry.increment(error))
        if (isImage(entry->path()) && files.size() < kMostImages)
            files.push_back(entry->path());
    if (error)
        return unexpected(ErrorCode::FileUnreadable, LocalizableText{"The folder %1 cannot be read.", {noted(path)}});
    if (files.empty())
        return unexpected(ErrorCode::WrongKind,
                          LocalizableText{"The folder %1 has no images (PNG, JPEG, BMP, PGM or TIFF).", {noted(path)}});
    std::sort(files.begin(), files.end());
    const PictureLibrary* const from = library();
    if (from == nullptr)
        return noLibrary();
    return std::make_unique<FolderSource>(*from, std::move(files));
}

}  // namespace core::tracking
