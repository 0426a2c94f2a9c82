// A shim after https://www.sqlite.org/vfs.html: every call goes on to the system's own layer.
#include "faulty_files.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <new>
#include <stdexcept>

namespace mixed_palletizing::torture {
namespace {

/// The file of the shim; the system's own follows it in memory.
struct File {
  sqlite3_file base;
  const char* path;  ///< SQLite keeps it as long as the file is open; null for temporary ones
};

sqlite3_vfs* system_vfs = nullptr;
sqlite3_vfs shim_vfs;

sqlite3_file* real(sqlite3_file* file) {
  return reinterpret_cast<sqlite3_file*>(reinterpret_cast<File*>(file) + 1);
}
const char* pathOf(sqlite3_file* file) { return reinterpret_cast<File*>(file)->path; }

std::string contentOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

struct FaultyFileMethods {
  static int write(sqlite3_file* file, const void* data, int size, sqlite3_int64 offset) {
    FaultyFiles& files = FaultyFiles::instance();
    if (const int code = files.next(false)) return code;
    if (pathOf(file) != nullptr) {
      files.written(pathOf(file),
                    {offset, size, {static_cast<const char*>(data), static_cast<std::size_t>(size)}});
    }
    return real(file)->pMethods->xWrite(real(file), data, size, offset);
  }
  static int truncate(sqlite3_file* file, sqlite3_int64 size) {
    FaultyFiles& files = FaultyFiles::instance();
    if (const int code = files.next(false)) return code;
    if (pathOf(file) != nullptr) files.written(pathOf(file), {-1, size, {}});
    return real(file)->pMethods->xTruncate(real(file), size);
  }
  static int sync(sqlite3_file* file, int flags) {
    FaultyFiles& files = FaultyFiles::instance();
    if (const int code = files.next(true)) return code;
    const int code = real(file)->pMethods->xSync(real(file), flags);
    if (code == SQLITE_OK && pathOf(file) != nullptr) files.synced(pathOf(file));
    return code;
  }
  static int close(sqlite3_file* f) { return real(f)->pMethods->xClose(real(f)); }
  static int read(sqlite3_file* f, void* to, int size, sqlite3_int64 at) {
    return real(f)->pMethods->xRead(real(f), to, size, at);
  }
  static int size(sqlite3_file* f, sqlite3_int64* bytes) {
    return real(f)->pMethods->xFileSize(real(f), bytes);
  }
  static int lock(sqlite3_file* f, int level) { return real(f)->pMethods->xLock(real(f), level); }
  static int unlock(sqlite3_file* f, int level) { return real(f)->pMethods->xUnlock(real(f), level); }
  static int reserved(sqlite3_file* f, int* is) { return real(f)->pMethods->xCheckReservedLock(real(f), is); }
  static int control(sqlite3_file* f, int op, void* arg) {
    return real(f)->pMethods->xFileControl(real(f), op, arg);
  }
  static int sector(sqlite3_file* f) { return real(f)->pMethods->xSectorSize(real(f)); }
  static int traits(sqlite3_file* f) { return real(f)->pMethods->xDeviceCharacteristics(real(f)); }
  static int shmMap(sqlite3_file* f, int page, int size, int extend, void volatile** to) {
    return real(f)->pMethods->xShmMap(real(f), page, size, extend, to);
  }
  static int shmLock(sqlite3_file* f, int offset, int n, int flags) {
    return real(f)->pMethods->xShmLock(real(f), offset, n, flags);
  }
  static void shmBarrier(sqlite3_file* f) { real(f)->pMethods->xShmBarrier(real(f)); }
  static int shmUnmap(sqlite3_file* f, int remove) { return real(f)->pMethods->xShmUnmap(real(f), remove); }

  static int remove(sqlite3_vfs*, const char* path, int sync_folder) {
    FaultyFiles& files = FaultyFiles::instance();
    if (const int code = files.next(false)) return code;
    files.removed(path);
    return system_vfs->xDelete(system_vfs, path, sync_folder);
  }
  static int open(sqlite3_vfs*, const char* path, sqlite3_file* file, int flags, int* out_flags) {
    static const sqlite3_io_methods kMethods{2,       close,      read,     write,   truncate, sync,   size,
                                             lock,    unlock,     reserved, control, sector,   traits, shmMap,
                                             shmLock, shmBarrier, shmUnmap, nullptr, nullptr};
    const int code = system_vfs->xOpen(system_vfs, path, real(file), flags, out_flags);
    reinterpret_cast<File*>(file)->path = path;
    file->pMethods = real(file)->pMethods == nullptr ? nullptr : &kMethods;
    if (code == SQLITE_OK && path != nullptr) FaultyFiles::instance().opened(path);
    return code;
  }
};

FaultyFiles& FaultyFiles::instance() {
  static FaultyFiles files;
  return files;
}

FaultyFiles::FaultyFiles() {
  system_vfs = sqlite3_vfs_find(nullptr);
  shim_vfs = *system_vfs;
  shim_vfs.pNext = nullptr;
  shim_vfs.zName = "faulty";
  shim_vfs.szOsFile = static_cast<int>(sizeof(File)) + system_vfs->szOsFile;
  shim_vfs.xOpen = FaultyFileMethods::open;
  shim_vfs.xDelete = FaultyFileMethods::remove;
  if (sqlite3_vfs_register(&shim_vfs, 1) != SQLITE_OK)
    throw std::runtime_error("FaultyFiles: not registered");
}

void FaultyFiles::reset() {
  count_ = 0;
  fail_at_ = -1;
  power_ = happened_ = forever_ = false;
  disk_.clear();
  since_sync_.clear();
}

void FaultyFiles::failAt(int at, int write_code, int sync_code, bool forever) {
  reset();
  fail_at_ = at;
  write_code_ = write_code;
  sync_code_ = sync_code;
  forever_ = forever;
}

void FaultyFiles::cutPowerAt(int at, std::uint64_t seed) {
  failAt(at, SQLITE_IOERR_WRITE, SQLITE_IOERR_FSYNC, true);
  power_ = true;
  rng_.seed(seed);
}

int FaultyFiles::next(bool is_sync) {
  const int now = count_++;
  const bool fails = fail_at_ >= 0 && (now == fail_at_ || (forever_ && now > fail_at_));
  if (!fails) return SQLITE_OK;
  if (power_ && !happened_) {
    for (auto& [path, writes] : since_sync_) {
      std::string& content = disk_[path];
      for (const Write& write : writes) {
        if (rng_() % 2 == 0) continue;  // never reached the disk
        if (write.offset < 0) {
          content.resize(static_cast<std::size_t>(write.size));
          continue;
        }
        const auto begin = static_cast<std::size_t>(write.offset);
        content.resize(std::max(content.size(), begin + write.bytes.size()));
        content.replace(begin, write.bytes.size(), write.bytes);
      }
    }
  }
  happened_ = true;
  return is_sync ? sync_code_ : write_code_;
}

void FaultyFiles::opened(const std::string& path) {
  if (power_ && !happened_ && disk_.count(path) == 0) disk_[path] = contentOf(path);
}

void FaultyFiles::written(const std::string& path, Write write) {
  if (power_) since_sync_[path].push_back(std::move(write));
}

void FaultyFiles::synced(const std::string& path) {
  if (!power_) return;
  disk_[path] = contentOf(path);
  since_sync_[path].clear();
}

void FaultyFiles::removed(const std::string& path) {
  if (!power_) return;
  disk_.erase(path);
  since_sync_.erase(path);
}

void FaultyFiles::restoreDisk() const {
  for (const auto& [path, content] : disk_) {
    std::filesystem::remove(path + "-shm");
    std::ofstream(path, std::ios::binary) << content;
  }
}

}  // namespace mixed_palletizing::torture
