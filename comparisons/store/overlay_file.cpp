#include "comparisons/store/overlay_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace springcheck {
namespace {

/// HDF5's view of an OverlayFile: a virtual file driver that keeps nothing but the
/// overlay's address and the end of allocated addresses.
struct DriverFile {
  H5FD_t base{};  // HDF5's own part comes first
  OverlayFile* overlay;
  haddr_t end_of_allocation;
};

DriverFile& driver_file(H5FD_t* file) {
  return *reinterpret_cast<DriverFile*>(file);
}
const DriverFile& driver_file(const H5FD_t* file) {
  return *reinterpret_cast<const DriverFile*>(file);
}

H5FD_t* open_driver(const char*, unsigned flags, hid_t access, haddr_t) {
  const auto* overlay = static_cast<OverlayFile* const*>(H5Pget_driver_info(access));
  if (overlay == nullptr) return nullptr;
  if ((flags & H5F_ACC_TRUNC) != 0) (*overlay)->resize(0);
  return &(new DriverFile{.overlay = *overlay, .end_of_allocation = 0})->base;
}

herr_t close_driver(H5FD_t* file) {
  delete &driver_file(file);
  return 0;
}

herr_t query(const H5FD_t*, unsigned long* flags) {
  if (flags != nullptr)
    *flags = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA |
             H5FD_FEAT_DATA_SIEVE | H5FD_FEAT_AGGREGATE_SMALLDATA |
             H5FD_FEAT_DEFAULT_VFD_COMPATIBLE;
  return 0;
}

haddr_t end_of_allocation(const H5FD_t* file, H5FD_mem_t) {
  return driver_file(file).end_of_allocation;
}

herr_t set_end_of_allocation(H5FD_t* file, H5FD_mem_t, haddr_t end) {
  driver_file(file).end_of_allocation = end;
  return 0;
}

haddr_t end_of_file(const H5FD_t* file, H5FD_mem_t) {
  return driver_file(file).overlay->size();
}

herr_t read_driver(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t place, size_t size,
                   void* bytes) {
  return driver_file(file).overlay->read(place, size, static_cast<char*>(bytes)) ? 0 : -1;
}

herr_t write_driver(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t place, size_t size,
                    const void* bytes) {
  return driver_file(file).overlay->write(place, size, static_cast<const char*>(bytes))
             ? 0
             : -1;
}

herr_t truncate_driver(H5FD_t* file, hid_t, hbool_t) {
  driver_file(file).overlay->resize(driver_file(file).end_of_allocation);
  return 0;
}

hid_t driver() {
  static const H5FD_class_t description = [] {
    H5FD_class_t c{};
    c.name = "springcheck overlay";
    c.maxaddr = HADDR_MAX;
    c.fc_degree = H5F_CLOSE_STRONG;
    c.fapl_size = sizeof(OverlayFile*);  // copied byte by byte
    c.open = open_driver;
    c.close = close_driver;
    c.query = query;
    c.get_eoa = end_of_allocation;
    c.set_eoa = set_end_of_allocation;
    c.get_eof = end_of_file;
    c.read = read_driver;
    c.write = write_driver;
    c.truncate = truncate_driver;
    const H5FD_mem_t map[] = H5FD_FLMAP_DICHOTOMY;
    std::ranges::copy(map, c.fl_map);
    return c;
  }();
  static const hid_t id = H5FDregister(&description);
  return id;
}

/// Version 1.8's format: readable since then, and without the mark "open for writing",
/// which a killed program would leave.
hid_t access_through(OverlayFile* overlay) {
  const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
  if (access < 0 || H5Pset_driver(access, driver(), &overlay) < 0 ||
      H5Pset_libver_bounds(access, H5F_LIBVER_V18, H5F_LIBVER_V18) < 0)
    throw std::runtime_error("HDF5: a driver could not be set");
  return access;
}

}  // namespace

OverlayFile::OverlayFile(const std::filesystem::path& file)
    : file_(file), descriptor_(::open(file.c_str(), O_RDONLY | O_CLOEXEC)) {
  if (descriptor_ < 0)
    throw std::runtime_error(file.string() + ": " + std::strerror(errno));
  writes_.file_size = std::filesystem::file_size(file);
}

OverlayFile::~OverlayFile() {
  close(descriptor_);
}

hid_t OverlayFile::open() {
  const hid_t access = access_through(this);
  const hid_t file = H5Fopen(file_.c_str(), H5F_ACC_RDWR, access);
  H5Pclose(access);
  return file;
}

hid_t OverlayFile::create() {
  const hid_t access = access_through(this);
  const hid_t file = H5Fcreate(file_.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access);
  H5Pclose(access);
  return file;
}

bool OverlayFile::read_disk(std::uint64_t place, std::size_t size, char* bytes) const {
  while (size > 0) {
    const ssize_t got = pread(descriptor_, bytes, size, static_cast<off_t>(place));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return false;
    if (got == 0) {  // beyond the end there are zeros
      std::memset(bytes, 0, size);
      return true;
    }
    bytes += got;
    place += static_cast<std::uint64_t>(got);
    size -= static_cast<std::size_t>(got);
  }
  return true;
}

bool OverlayFile::read(std::uint64_t place, std::size_t size, char* bytes) const {
  if (!read_disk(place, size, bytes)) return false;
  if (size == 0) return true;
  const std::uint64_t end = place + size;
  for (auto page = writes_.pages.lower_bound(place / page_size);
       page != writes_.pages.end() && page->first * page_size < end; ++page) {
    const std::uint64_t start = page->first * page_size;
    const std::uint64_t from = std::max(place, start),
                        to = std::min(end, start + page_size);
    std::memcpy(bytes + (from - place), page->second.data() + (from - start), to - from);
  }
  return true;
}

bool OverlayFile::write(std::uint64_t place, std::size_t size, const char* bytes) {
  while (size > 0) {
    const std::uint64_t number = place / page_size, offset = place % page_size;
    const std::size_t part = std::min<std::size_t>(size, page_size - offset);
    const auto [page, is_new] = writes_.pages.try_emplace(number);
    if (is_new && !read_disk(number * page_size, page_size, page->second.data()))
      return false;
    std::memcpy(page->second.data() + offset, bytes, part);
    bytes += part;
    place += part;
    size -= part;
  }
  writes_.file_size = std::max(writes_.file_size, place);
  return true;
}

}  // namespace springcheck
