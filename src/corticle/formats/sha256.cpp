// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/sha256.hpp"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <array>
#include <fstream>
#include <memory>
#include <span>
#include <vector>

namespace corticle::formats
{

namespace
{

std::string hexadecimal(std::span<const unsigned char> bytes)
{
    std::string text;
    for (const unsigned char byte : bytes)
    {
        text += fmt::format("{:02x}", byte);
    }
    return text;
}

} // namespace

std::string sha256_of_file(const std::filesystem::path& file)
{
    std::ifstream stream(file, std::ios::binary);
    const std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context(EVP_MD_CTX_new(), EVP_MD_CTX_free);
    if (!stream || !context || EVP_DigestInit_ex(context.get(), EVP_sha256(), nullptr) != 1)
    {
        return {};
    }
    std::vector<char> buffer(1 << 20);
    while (stream.read(buffer.data(), std::ssize(buffer)) || stream.gcount() > 0)
    {
        EVP_DigestUpdate(context.get(), buffer.data(), static_cast<std::size_t>(stream.gcount()));
    }
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned int size = 0;
    if (stream.bad() || EVP_DigestFinal_ex(context.get(), digest.data(), &size) != 1)
    {
        return {};
    }
    return hexadecimal(std::span(digest).first(size));
}

std::string sha256_of_text(std::string_view text)
{
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned int size = 0;
    const bool is_made = EVP_Digest(text.data(), text.size(), digest.data(), &size, EVP_sha256(), nullptr) == 1;
    return hexadecimal(std::span(digest).first(is_made ? size : 0));
}

} // namespace corticle::formats
