#include "image/image_file.h"
#include "core/error.h"

#include <gtest/gtest.h>

#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <bit>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <random>
#include <string>

namespace timeshade {
namespace {

namespace fs = std::filesystem;

class ImageFile : public testing::Test {
  protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "timeshade-image-XXXXXX").string();
        ASSERT_NE(mkdtemp(name.data()), nullptr);
        folder_ = name;
    }
    void TearDown() override { fs::remove_all(folder_); }

    fs::path in(const std::string& name) const { return folder_ / name; }

    std::size_t entries(const fs::path& folder) const {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
    }

    fs::path folder_;
};

std::string contentsOf(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// The message of the Error that the call throws; empty if it throws none.
template <class Call>
std::string errorOf(const Call& call) {
    try {
        call();
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

DisplayImage noisyPicture(int width, int height) {
    DisplayImage image{width, height, {}};
    std::mt19937 random(7);
    for (int i = 0; i < width * height * 3; ++i) {
        image.rgb.push_back(static_cast<std::uint8_t>(random()));
    }
    return image;
}

/// Any bit pattern: infinities, NaNs and denormal numbers among them.
LinearImage anyBits(int width, int height) {
    LinearImage image{width, height, {}};
    std::mt19937 random(11);
    for (int i = 0; i < width * height * 3; ++i) {
        image.rgb.push_back(std::bit_cast<float>(static_cast<std::uint32_t>(random())));
    }
    return image;
}

LinearImage smoothPicture(int width, int height) {
    LinearImage image{width, height, {}};
    for (int i = 0; i < width * height * 3; ++i) {
        image.rgb.push_back(static_cast<float>(i) / 64.0f);
    }
    return image;
}

std::vector<std::uint32_t> bitsOf(const LinearImage& image) {
    std::vector<std::uint32_t> bits;
    for (const float value : image.rgb) {
        bits.push_back(std::bit_cast<std::uint32_t>(value));
    }
    return bits;
}

/// Root may write anywhere, so that permissions can be tested only as somebody else.
class OrdinaryUser {
  public:
    OrdinaryUser() {
        if (geteuid() == 0 && seteuid(nobody) == 0) {
            changed_ = true;
        }
    }
    ~OrdinaryUser() {
        if (changed_ && seteuid(0) != 0) {
            std::abort();
        }
    }
    OrdinaryUser(const OrdinaryUser&) = delete;
    OrdinaryUser& operator=(const OrdinaryUser&) = delete;

  private:
    static constexpr uid_t nobody = 65534;
    bool changed_ = false;
};

TEST_F(ImageFile, PngRoundTripKeepsEveryByte) {
    for (const auto& [width, height] : {std::pair{1, 1}, std::pair{7, 5}, std::pair{640, 3}, std::pair{3, 300}}) {
        const DisplayImage written = noisyPicture(width, height);
        writePng(in("a.png"), written);
        const DisplayImage read = readPng(in("a.png"));
        EXPECT_EQ(read.width, width);
        EXPECT_EQ(read.height, height);
        EXPECT_EQ(read.rgb, written.rgb);
    }
}

TEST_F(ImageFile, ExrRoundTripKeepsEveryBit) {
    // Heights on both sides of ZIP's blocks of 16 lines; noise does not compress, which takes another path.
    for (const int height : {1, 15, 16, 17, 33}) {
        for (const LinearImage& written : {anyBits(13, height), smoothPicture(40, height)}) {
            writeExr(in("a.exr"), written);
            const LinearImage read = readExr(in("a.exr"));
            EXPECT_EQ(read.width, written.width);
            EXPECT_EQ(read.height, height);
            EXPECT_EQ(bitsOf(read), bitsOf(written));
        }
    }
}

TEST_F(ImageFile, ExrKeepsNanAndInfinity) {
    const float infinity = std::numeric_limits<float>::infinity();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const LinearImage written{2, 1, {nan, infinity, -infinity, -0.0f, 1e-42f, nan}};
    writeExr(in("a.exr"), written);
    EXPECT_EQ(bitsOf(readExr(in("a.exr"))), bitsOf(written));
}

TEST_F(ImageFile, EqualPixelsGiveEqualBytes) {
    writePng(in("a.png"), noisyPicture(64, 48));
    writePng(in("b.png"), noisyPicture(64, 48));
    EXPECT_EQ(contentsOf(in("a.png")), contentsOf(in("b.png")));
    writeExr(in("a.exr"), smoothPicture(64, 48));
    writeExr(in("b.exr"), smoothPicture(64, 48));
    EXPECT_EQ(contentsOf(in("a.exr")), contentsOf(in("b.exr")));
}

TEST_F(ImageFile, ReplacesAnOldFileAndKeepsItsModeAndLinks) {
    writeFileAtomically(in("real.txt"), std::string("old"));
    fs::permissions(in("real.txt"), fs::perms(0640));
    fs::create_symlink("real.txt", in("link.txt"));
    fs::create_symlink("later.txt", in("dangling.txt"));

    writeFileAtomically(in("link.txt"), std::string("new"));
    writeFileAtomically(in("dangling.txt"), std::string("first"));

    EXPECT_TRUE(fs::is_symlink(in("link.txt")));
    EXPECT_EQ(contentsOf(in("real.txt")), "new");
    EXPECT_EQ(fs::status(in("real.txt")).permissions(), fs::perms(0640));
    EXPECT_EQ(contentsOf(in("later.txt")), "first");
    EXPECT_EQ(entries(folder_), 4u);
}

TEST_F(ImageFile, TakesTheLongestNameAFolderHolds) {
    const fs::path longest = in(std::string(251, 'n') + ".txt");
    writeFileAtomically(longest, std::string("text"));
    EXPECT_EQ(contentsOf(longest), "text");
    EXPECT_EQ(entries(folder_), 1u);
}

TEST_F(ImageFile, FullDeviceIsNamed) {
    fs::create_symlink("/dev/full", in("full.png"));
    const std::string error = errorOf([&] { writePng(in("full.png"), noisyPicture(8, 8)); });
    EXPECT_EQ(error, "cannot write " + in("full.png").string() + ": No space left on device");
    EXPECT_TRUE(fs::is_character_file("/dev/full")) << "a device must never be replaced";
    EXPECT_EQ(entries(folder_), 1u);
}

TEST_F(ImageFile, MissingFolderIsNamed) {
    const fs::path path = in("no/such/a.exr");
    const std::string expected = "cannot write " + path.string() +
                                 ": No such file or directory; expected an existing folder " + in("no/such").string();
    EXPECT_EQ(errorOf([&] { requireWritable(path); }), expected);
    EXPECT_EQ(errorOf([&] { writeExr(path, smoothPicture(4, 4)); }), expected);
}

TEST_F(ImageFile, FolderInItsPlaceIsNamed) {
    fs::create_directory(in("a.png"));
    for (const fs::path& path : {in("a.png"), in("a.png/")}) {
        const std::string expected = "cannot write " + path.string() + ": Is a directory; expected a file name";
        EXPECT_EQ(errorOf([&] { requireWritable(path); }), expected);
        EXPECT_EQ(errorOf([&] { writePng(path, noisyPicture(4, 4)); }), expected);
    }
    EXPECT_EQ(errorOf([] { requireWritable(""); }),
              "cannot write \"\": No such file or directory; expected a file name");
}

TEST_F(ImageFile, FileInPlaceOfAFolderIsNamed) {
    writeFileAtomically(in("file"), std::string("text"));
    EXPECT_NE(errorOf([&] { requireWritable(in("file/a.png")); }).find("Not a directory"), std::string::npos);
}

TEST_F(ImageFile, ReadOnlyFolderAndFileAreNamed) {
    writeFileAtomically(in("old.txt"), std::string("old"));
    fs::permissions(in("old.txt"), fs::perms(0444));
    fs::permissions(folder_, fs::perms(0555));
    {
        const OrdinaryUser ordinary;
        for (const char* name : {"new.txt", "old.txt"}) {
            const std::string expected = "cannot write " + in(name).string() + ": Permission denied";
            EXPECT_EQ(errorOf([&] { requireWritable(in(name)); }), expected);
            EXPECT_EQ(errorOf([&] { writeFileAtomically(in(name), std::string("new")); }), expected);
        }
    }
    fs::permissions(folder_, fs::perms(0755));
    EXPECT_EQ(contentsOf(in("old.txt")), "old");
    EXPECT_EQ(entries(folder_), 1u);
}

TEST_F(ImageFile, RequireWritableLeavesNothing) {
    requireWritable(in("new.png"));
    EXPECT_EQ(entries(folder_), 0u);
    writeFileAtomically(in("old.txt"), std::string("old"));
    requireWritable(in("old.txt"));
    EXPECT_EQ(contentsOf(in("old.txt")), "old");
    EXPECT_EQ(entries(folder_), 1u);
}

TEST_F(ImageFile, ShortWriteKeepsTheOldFile) {
    writeFileAtomically(in("a.txt"), std::string("old"));
    // The kernel writes up to the limit, then refuses: a disk that fills up in the middle of a file.
    rlimit old{};
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &old), 0);
    const auto oldHandler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit small{4096, old.rlim_max};
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
    const std::string error = errorOf([&] { writeFileAtomically(in("a.txt"), std::string(10000, 'x')); });
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &old), 0);
    std::signal(SIGXFSZ, oldHandler);

    EXPECT_EQ(error, "cannot write " + in("a.txt").string() + ": File too large");
    EXPECT_EQ(contentsOf(in("a.txt")), "old");
    EXPECT_EQ(entries(folder_), 1u);
}

TEST_F(ImageFile, FullDiskKeepsTheOldFile) {
    const fs::path disk = in("disk");
    fs::create_directory(disk);
    if (mount("tmpfs", disk.c_str(), "tmpfs", 0, "size=64k") != 0) {
        GTEST_SKIP() << "mounting a small disk needs root";
    }
    writeFileAtomically(disk / "a.exr", std::string("old"));
    const std::string error = errorOf([&] { writeExr(disk / "a.exr", anyBits(200, 200)); });
    EXPECT_EQ(error, "cannot write " + (disk / "a.exr").string() + ": No space left on device");
    EXPECT_EQ(contentsOf(disk / "a.exr"), "old");
    EXPECT_EQ(entries(disk), 1u);
    EXPECT_EQ(umount(disk.c_str()), 0);
}

TEST_F(ImageFile, UnreadableFilesAreNamed) {
    EXPECT_EQ(errorOf([&] { readPng(in("none.png")); }),
              "cannot read " + in("none.png").string() + ": No such file or directory");
    EXPECT_EQ(errorOf([&] { readExr(folder_); }), "cannot read " + folder_.string() + ": Is a directory");
    writeFileAtomically(in("text"), std::string("not a picture"));
    EXPECT_NE(errorOf([&] { readPng(in("text")); }).find("expected a PNG"), std::string::npos);
    EXPECT_NE(errorOf([&] { readExr(in("text")); }).find("not an EXR"), std::string::npos);
}

TEST_F(ImageFile, CutFilesAreRefusedAtAnyLength) {
    writePng(in("whole.png"), noisyPicture(9, 9));
    writeExr(in("whole.exr"), smoothPicture(9, 9));
    const std::string png = contentsOf(in("whole.png"));
    const std::string exr = contentsOf(in("whole.exr"));
    for (std::size_t length = 0; length + 16 < png.size(); length += 5) {
        writeFileAtomically(in("cut.png"), std::span(png).first(length));
        EXPECT_NE(errorOf([&] { readPng(in("cut.png")); }), "") << length;
    }
    for (std::size_t length = 0; length < exr.size(); length += 5) {
        writeFileAtomically(in("cut.exr"), std::span(exr).first(length));
        EXPECT_NE(errorOf([&] { readExr(in("cut.exr")); }), "") << length;
    }
}

}  // namespace
}  // namespace timeshade
