// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/record/checkpoint_image.hpp"

#include <hdf5.h>

#include <array>
#include <stdexcept>

namespace corticle::record
{

namespace
{

struct Hdf5Failure : std::runtime_error
{
    Hdf5Failure() : std::runtime_error("HDF5") {}
};

template <class Result>
Result checked(Result result)
{
    if (result < 0)
    {
        throw Hdf5Failure();
    }
    return result;
}

/// An HDF5 identifier that closes itself.
class Handle
{
  public:
    Handle(hid_t id, herr_t (*close)(hid_t)) : id_(checked(id)), close_(close) {}
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;
    ~Handle() { close_(id_); }
    operator hid_t() const { return id_; }

  private:
    hid_t id_;
    herr_t (*close_)(hid_t);
};

/// Keeps HDF5 from printing its error stack.
class QuietErrors
{
  public:
    QuietErrors()
    {
        H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
        H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    }
    QuietErrors(const QuietErrors&) = delete;
    QuietErrors& operator=(const QuietErrors&) = delete;
    ~QuietErrors() { H5Eset_auto2(H5E_DEFAULT, function_, data_); }

  private:
    H5E_auto2_t function_ = nullptr;
    void* data_ = nullptr;
};

constexpr std::size_t growth_step = 1 << 20;

// How the three kinds of array lie in memory and in the file. A Vec3 is four doubles wide in memory, three in the file.
struct Layout
{
    hid_t memory_type;
    hid_t file_type;
    hsize_t components;
    hsize_t stride;
};
Layout layout_of(const Vec3*)
{
    return {H5T_NATIVE_DOUBLE, H5T_IEEE_F64LE, 3, sizeof(Vec3) / sizeof(double)};
}
Layout layout_of(const double*)
{
    return {H5T_NATIVE_DOUBLE, H5T_IEEE_F64LE, 1, 1};
}
Layout layout_of(const std::int64_t*)
{
    return {H5T_NATIVE_INT64, H5T_STD_I64LE, 1, 1};
}

Handle memory_space(const Layout& layout, hsize_t count)
{
    const std::array<hsize_t, 2> whole{count, layout.stride};
    const std::array<hsize_t, 2> start{0, 0};
    const std::array<hsize_t, 2> used{count, layout.components};
    const hid_t space = checked(H5Screate_simple(2, whole.data(), nullptr));
    if (count > 0)
    {
        H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, used.data(), nullptr);
    }
    return Handle(space, H5Sclose);
}

/// Objects carry no times, so that the same state gives the same bytes.
Handle without_times(hid_t list_class)
{
    const hid_t list = checked(H5Pcreate(list_class));
    H5Pset_obj_track_times(list, false);
    return Handle(list, H5Pclose);
}

template <class Value>
void write_group(hid_t file, const char* name, const std::map<std::string, std::vector<Value>>& arrays)
{
    const Handle group_list(checked(H5Pcreate(H5P_GROUP_CREATE)), H5Pclose);
    H5Pset_obj_track_times(group_list, false);
    const Handle group(H5Gcreate2(file, name, H5P_DEFAULT, group_list, H5P_DEFAULT), H5Gclose);
    const Handle list = without_times(H5P_DATASET_CREATE);
    for (const auto& [key, values] : arrays)
    {
        const Layout layout = layout_of(values.data());
        const std::array<hsize_t, 2> size{values.size(), layout.components};
        const Handle space(H5Screate_simple(layout.components == 1 ? 1 : 2, size.data(), nullptr), H5Sclose);
        const Handle set(H5Dcreate2(group, key.c_str(), layout.file_type, space, H5P_DEFAULT, list, H5P_DEFAULT),
                         H5Dclose);
        if (!values.empty())
        {
            const Handle memory = memory_space(layout, values.size());
            checked(H5Dwrite(set, layout.memory_type, memory, H5S_ALL, H5P_DEFAULT, values.data()));
        }
    }
}

template <class Value>
void read_array(hid_t group, const std::string& key, std::vector<Value>& values)
{
    const Layout layout = layout_of(values.data());
    const Handle set(H5Dopen2(group, key.c_str(), H5P_DEFAULT), H5Dclose);
    const Handle space(H5Dget_space(set), H5Sclose);
    const hssize_t numbers = checked(H5Sget_simple_extent_npoints(space));
    if (numbers % static_cast<hssize_t>(layout.components) != 0)
    {
        throw Hdf5Failure();
    }
    values.resize(static_cast<std::size_t>(numbers) / layout.components);
    if (!values.empty())
    {
        const Handle memory = memory_space(layout, values.size());
        checked(H5Dread(set, layout.memory_type, memory, H5S_ALL, H5P_DEFAULT, values.data()));
    }
}

template <class Value>
void read_group(hid_t file, const char* name, std::map<std::string, std::vector<Value>>& arrays)
{
    const Handle group(H5Gopen2(file, name, H5P_DEFAULT), H5Gclose);
    H5G_info_t info;
    checked(H5Gget_info(group, &info));
    for (hsize_t i = 0; i < info.nlinks; ++i)
    {
        const ssize_t length =
            checked(H5Lget_name_by_idx(group, ".", H5_INDEX_NAME, H5_ITER_INC, i, nullptr, 0, H5P_DEFAULT));
        std::string key(static_cast<std::size_t>(length), '\0');
        checked(H5Lget_name_by_idx(group, ".", H5_INDEX_NAME, H5_ITER_INC, i, key.data(), key.size() + 1, H5P_DEFAULT));
        read_array(group, key, arrays[key]);
    }
}

/// Text is kept as bytes, so that any length, zero too, comes back as it was.
void write_text(hid_t file, const char* name, const std::string& text)
{
    const Handle list = without_times(H5P_DATASET_CREATE);
    const hsize_t size = text.size();
    const Handle space(H5Screate_simple(1, &size, nullptr), H5Sclose);
    const Handle set(H5Dcreate2(file, name, H5T_STD_U8LE, space, H5P_DEFAULT, list, H5P_DEFAULT), H5Dclose);
    if (!text.empty())
    {
        checked(H5Dwrite(set, H5T_NATIVE_UCHAR, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()));
    }
}

std::string read_text(hid_t file, const char* name)
{
    const Handle set(H5Dopen2(file, name, H5P_DEFAULT), H5Dclose);
    const Handle space(H5Dget_space(set), H5Sclose);
    std::string text(static_cast<std::size_t>(checked(H5Sget_simple_extent_npoints(space))), '\0');
    if (!text.empty())
    {
        checked(H5Dread(set, H5T_NATIVE_UCHAR, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.data()));
    }
    return text;
}

void write_magic(hid_t file)
{
    constexpr std::array<char, 20> text{"corticle checkpoint"};
    const Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
    checked(H5Tset_size(type, text.size()));
    const Handle space(H5Screate(H5S_SCALAR), H5Sclose);
    const Handle attribute(H5Acreate2(file, "magic", type, space, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    checked(H5Awrite(attribute, type, text.data()));
}

} // namespace

bool append_checkpoint_image(const Checkpoint& checkpoint, std::string& bytes)
{
    const QuietErrors quiet;
    try
    {
        const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
        checked(H5Pset_fapl_core(access, growth_step, false));
        const Handle creation = without_times(H5P_FILE_CREATE);
        const Handle file(H5Fcreate("checkpoint in memory", H5F_ACC_TRUNC, creation, access), H5Fclose);
        write_magic(file);
        write_text(file, "program_version", checkpoint.program_version);
        write_text(file, "case", checkpoint.case_text);
        write_group(file, "vectors", checkpoint.vectors);
        write_group(file, "scalars", checkpoint.scalars);
        write_group(file, "integers", checkpoint.integers);
        checked(H5Fflush(file, H5F_SCOPE_LOCAL));
        const auto size = static_cast<std::size_t>(checked(H5Fget_file_image(file, nullptr, 0)));
        const std::size_t begin = bytes.size();
        bytes.resize(begin + size);
        checked(H5Fget_file_image(file, bytes.data() + begin, size));
        return true;
    }
    catch (const Hdf5Failure&)
    {
        return false;
    }
}

bool parse_checkpoint_image(std::string_view image, Checkpoint& checkpoint)
{
    const QuietErrors quiet;
    try
    {
        const Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
        checked(H5Pset_fapl_core(access, growth_step, false));
        checked(H5Pset_file_image(access, const_cast<char*>(image.data()), image.size()));
        const Handle file(H5Fopen("checkpoint in memory", H5F_ACC_RDONLY, access), H5Fclose);
        checked(H5Aexists(file, "magic") > 0 ? 0 : -1);
        checkpoint.program_version = read_text(file, "program_version");
        checkpoint.case_text = read_text(file, "case");
        read_group(file, "vectors", checkpoint.vectors);
        read_group(file, "scalars", checkpoint.scalars);
        read_group(file, "integers", checkpoint.integers);
        return true;
    }
    catch (const Hdf5Failure&)
    {
        return false;
    }
}

} // namespace corticle::record
