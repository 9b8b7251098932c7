// A cache that gives back exactly what was stored, or nothing.

#include "measure/reference_cache.h"
#include "core/sha256.h"

#include <gtest/gtest.h>

#include <sys/stat.h>
#include <unistd.h>

#include <bit>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <random>

namespace timeshade {
namespace {

namespace fs = std::filesystem;

std::string hexOf(const std::string& text) {
    return toHex(sha256({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}));
}

// The examples that NIST publishes with FIPS 180-4.
TEST(Sha256, PublishedExamples) {
    EXPECT_EQ(hexOf(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(hexOf("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(hexOf("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
              "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    EXPECT_EQ(hexOf(std::string(1000000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

class ReferenceCacheTest : public testing::Test {
  protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "timeshade-cache-XXXXXX").string();
        ASSERT_NE(mkdtemp(name.data()), nullptr);
        root_ = name;
        folder_ = root_ / "made" / "when needed";
    }
    void TearDown() override { fs::remove_all(root_); }

    fs::path root_;
    fs::path folder_;
    const std::string key_ = "scene pillars, frame 3, 4096 spp, seed 7";
};

/// Any bit pattern: infinities, NaNs and denormal numbers among them.
LinearImage anyBits(int width, int height, unsigned seed = 11) {
    LinearImage image{width, height, {}};
    std::mt19937 random(seed);
    for (int i = 0; i < width * height * 3; ++i) {
        image.rgb.push_back(std::bit_cast<float>(static_cast<std::uint32_t>(random())));
    }
    image.rgb[0] = std::numeric_limits<float>::signaling_NaN();
    return image;
}

bool sameBits(const LinearImage& a, const LinearImage& b) {
    return a.width == b.width && a.height == b.height &&
           std::equal(a.rgb.begin(), a.rgb.end(), b.rgb.begin(), b.rgb.end(), [](float x, float y) {
               return std::bit_cast<std::uint32_t>(x) == std::bit_cast<std::uint32_t>(y);
           });
}

std::string contentsOf(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

void write(const fs::path& path, const std::string& bytes) {
    std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

TEST_F(ReferenceCacheTest, GivesBackEveryBit) {
    const ReferenceCache cache(folder_);
    EXPECT_FALSE(cache.load(key_, 7, 5).has_value());
    const LinearImage image = anyBits(7, 5);
    ASSERT_TRUE(cache.store(key_, image));
    const auto loaded = ReferenceCache(folder_).load(key_, 7, 5);
    ASSERT_TRUE(loaded.has_value());
    EXPECT_TRUE(sameBits(*loaded, image));
    EXPECT_TRUE(cache.load(key_, 7, 5).has_value()) << "loading leaves it there";

    const LinearImage newer = anyBits(7, 5, 12);
    ASSERT_TRUE(cache.store(key_, newer));
    EXPECT_TRUE(sameBits(*cache.load(key_, 7, 5), newer));
}

TEST_F(ReferenceCacheTest, AnyKey) {
    const ReferenceCache cache(folder_);
    const std::vector<std::string> keys = {"",
                                           std::string("nul\0inside", 10),
                                           std::string("nul\0other", 9),
                                           "../../etc/passwd",
                                           "line\nbreak",
                                           std::string(100000, 'k')};
    for (unsigned i = 0; i < keys.size(); ++i) {
        ASSERT_TRUE(cache.store(keys[i], anyBits(2, 2, i)));
    }
    for (unsigned i = 0; i < keys.size(); ++i) {
        const auto loaded = cache.load(keys[i], 2, 2);
        ASSERT_TRUE(loaded.has_value());
        EXPECT_TRUE(sameBits(*loaded, anyBits(2, 2, i)));
    }
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()),
              static_cast<std::ptrdiff_t>(keys.size()));
}

TEST_F(ReferenceCacheTest, OtherKeyAndOtherSizeAreNotThere) {
    const ReferenceCache cache(folder_);
    ASSERT_TRUE(cache.store(key_, anyBits(6, 4)));
    EXPECT_FALSE(cache.load(key_ + " ", 6, 4).has_value());
    EXPECT_FALSE(cache.load("", 6, 4).has_value());
    EXPECT_FALSE(cache.load(key_, 4, 6).has_value());
    EXPECT_FALSE(cache.load(key_, 6, 5).has_value());
    EXPECT_FALSE(cache.load(key_, 0, 0).has_value());
    EXPECT_FALSE(cache.load(key_, -6, -4).has_value());
    EXPECT_FALSE(cache.load(key_, std::numeric_limits<int>::max(), std::numeric_limits<int>::max()).has_value());
    EXPECT_TRUE(cache.load(key_, 6, 4).has_value()) << "asking for others does not harm it";
}

TEST_F(ReferenceCacheTest, FileUnderAnotherKeysNameIsRefusedAndDeleted) {
    const ReferenceCache cache(folder_);
    ASSERT_TRUE(cache.store("first key", anyBits(3, 2)));
    const fs::path other = cache.fileOf("other key", 3, 2);
    fs::copy_file(cache.fileOf("first key", 3, 2), other);
    EXPECT_FALSE(cache.load("other key", 3, 2).has_value());
    EXPECT_FALSE(fs::exists(other));

    const fs::path turned = cache.fileOf("first key", 2, 3);
    fs::copy_file(cache.fileOf("first key", 3, 2), turned);
    EXPECT_FALSE(cache.load("first key", 2, 3).has_value());
    EXPECT_FALSE(fs::exists(turned));
}

TEST_F(ReferenceCacheTest, AnyFlippedByteIsFound) {
    const ReferenceCache cache(folder_);
    const LinearImage image = anyBits(3, 2);
    ASSERT_TRUE(cache.store(key_, image));
    const fs::path file = cache.fileOf(key_, 3, 2);
    const std::string whole = contentsOf(file);
    for (std::size_t place = 0; place < whole.size(); ++place) {
        for (const int flip : {0x01, 0x80, 0xff}) {
            std::string damaged = whole;
            damaged[place] = static_cast<char>(damaged[place] ^ flip);
            write(file, damaged);
            ASSERT_FALSE(cache.load(key_, 3, 2).has_value()) << "byte " << place;
            ASSERT_FALSE(fs::exists(file)) << "byte " << place;
        }
    }
    write(file, whole);
    EXPECT_TRUE(cache.load(key_, 3, 2).has_value());
}

TEST_F(ReferenceCacheTest, AnyOtherLengthIsFound) {
    const ReferenceCache cache(folder_);
    ASSERT_TRUE(cache.store(key_, anyBits(3, 2)));
    const fs::path file = cache.fileOf(key_, 3, 2);
    const std::string whole = contentsOf(file);
    for (std::size_t size = 0; size < whole.size(); ++size) {
        write(file, whole.substr(0, size));
        ASSERT_FALSE(cache.load(key_, 3, 2).has_value()) << "cut to " << size;
        ASSERT_FALSE(fs::exists(file));
    }
    write(file, whole + '\0');
    EXPECT_FALSE(cache.load(key_, 3, 2).has_value());
    write(file, whole + whole);
    EXPECT_FALSE(cache.load(key_, 3, 2).has_value());
}

TEST_F(ReferenceCacheTest, WhatIsNoFileIsLeftAlone) {
    const ReferenceCache cache(folder_);
    const fs::path file = cache.fileOf(key_, 3, 2);
    fs::create_directories(file);
    EXPECT_FALSE(cache.load(key_, 3, 2).has_value());
    EXPECT_FALSE(cache.store(key_, anyBits(3, 2)));
    EXPECT_TRUE(fs::is_directory(file));
    fs::remove(file);
    // A pipe that nobody writes to: opening it would wait for ever.
    ASSERT_EQ(mkfifo(file.c_str(), 0600), 0);
    EXPECT_FALSE(cache.load(key_, 3, 2).has_value());
}

TEST_F(ReferenceCacheTest, FolderThatCannotBeWritten) {
    write(root_ / "file", "not a folder");
    const ReferenceCache inFile(root_ / "file" / "cache");
    EXPECT_FALSE(inFile.store(key_, anyBits(3, 2)));
    EXPECT_FALSE(inFile.load(key_, 3, 2).has_value());
    const ReferenceCache inKernel("/proc/timeshade");
    EXPECT_FALSE(inKernel.store(key_, anyBits(3, 2)));

    if (geteuid() != 0) {  // root writes everywhere
        fs::create_directory(root_ / "locked");
        fs::permissions(root_ / "locked", fs::perms::owner_read | fs::perms::owner_exec);
        EXPECT_FALSE(ReferenceCache(root_ / "locked").store(key_, anyBits(3, 2)));
        fs::permissions(root_ / "locked", fs::perms::owner_all);
    }
}

TEST_F(ReferenceCacheTest, NoFolderAndNoImage) {
    const ReferenceCache nowhere{fs::path()};
    EXPECT_FALSE(nowhere.store(key_, anyBits(3, 2)));
    EXPECT_FALSE(nowhere.load(key_, 3, 2).has_value());
    const ReferenceCache cache(folder_);
    EXPECT_FALSE(cache.store(key_, LinearImage{}));
    EXPECT_FALSE(cache.store(key_, LinearImage{2, 2, {1.0f}}));
}

TEST_F(ReferenceCacheTest, OldestGoFirstAndForeignFilesStay) {
    // Files of 40x40 images hold about 19 kB: two fit, three do not.
    const ReferenceCache cache(folder_, 50000);
    ASSERT_TRUE(cache.store("a", anyBits(40, 40)));
    ASSERT_TRUE(cache.store("b", anyBits(40, 40)));
    write(folder_ / "notes.txt", std::string(100000, 'n'));
    const fs::path leftover = cache.fileOf("c", 40, 40).string() + ".123-0.part";
    write(leftover, "half");
    const auto now = fs::file_time_type::clock::now();
    fs::last_write_time(cache.fileOf("a", 40, 40), now - std::chrono::hours(3));
    fs::last_write_time(cache.fileOf("b", 40, 40), now - std::chrono::hours(2));
    fs::last_write_time(folder_ / "notes.txt", now - std::chrono::hours(4));
    fs::last_write_time(leftover, now - std::chrono::hours(2));
    ASSERT_TRUE(cache.load("a", 40, 40).has_value());  // used just now: b is the oldest

    ASSERT_TRUE(cache.store("c", anyBits(40, 40)));
    EXPECT_TRUE(cache.load("a", 40, 40).has_value());
    EXPECT_FALSE(cache.load("b", 40, 40).has_value());
    EXPECT_TRUE(cache.load("c", 40, 40).has_value());
    EXPECT_TRUE(fs::exists(folder_ / "notes.txt"));
    EXPECT_FALSE(fs::exists(leftover));

    const ReferenceCache tiny(folder_, 1);
    ASSERT_TRUE(tiny.store("d", anyBits(40, 40)));
    EXPECT_TRUE(tiny.load("d", 40, 40).has_value()) << "what was just stored stays";
    EXPECT_FALSE(tiny.load("a", 40, 40).has_value());
}

/// Sets a variable of the environment for as long as it lives; a null value unsets it.
class Environment {
  public:
    Environment(const char* name, const char* value) : name_(name) {
        if (const char* old = std::getenv(name)) {
            old_ = old;
        }
        set(value);
    }
    ~Environment() { set(old_ ? old_->c_str() : nullptr); }
    Environment(const Environment&) = delete;
    Environment& operator=(const Environment&) = delete;

  private:
    void set(const char* value) { value != nullptr ? setenv(name_, value, 1) : unsetenv(name_); }

    const char* name_;
    std::optional<std::string> old_;
};

TEST(ReferenceCacheFolder, FollowsTheEnvironment) {
    const Environment home("HOME", "/home/someone");
    {
        const Environment cache("XDG_CACHE_HOME", "/var/quick");
        EXPECT_EQ(ReferenceCache::defaultFolder(), "/var/quick/timeshade");
    }
    for (const char* ignored : {static_cast<const char*>(nullptr), "", "relative/path"}) {
        const Environment cache("XDG_CACHE_HOME", ignored);
        EXPECT_EQ(ReferenceCache::defaultFolder(), "/home/someone/.cache/timeshade");
    }
    const Environment cache("XDG_CACHE_HOME", nullptr);
    const Environment homeless("HOME", nullptr);
    EXPECT_EQ(ReferenceCache::defaultFolder(), "");
}

}  // namespace
}  // namespace timeshade
