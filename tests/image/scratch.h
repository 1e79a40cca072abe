#pragma once
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <string>
#include <unistd.h>
#include <vector>

namespace nacre {

/// A test with an empty folder of its own, which goes when the test does.
class Scratch : public ::testing::Test {
  protected:
    Scratch() {
        const auto *test = ::testing::UnitTest::GetInstance()->current_test_info();
        folder = std::filesystem::temp_directory_path() /
                 (std::string("nacre-") + test->name() + "-" + std::to_string(getpid()));
        std::filesystem::create_directories(folder);
    }
    ~Scratch() override {
        std::error_code ignored;
        std::filesystem::remove_all(folder, ignored);
    }

    static std::string bytes_of(const std::filesystem::path &file) {
        std::ifstream in(file, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    static void put(const std::filesystem::path &file, const std::string &bytes) {
        std::ofstream(file, std::ios::binary) << bytes;
    }
    std::size_t files() const { return std::size_t(std::distance(std::filesystem::directory_iterator(folder), {})); }

    std::filesystem::path folder;
};

} // namespace nacre
