// SPDX-License-Identifier: GPL-3.0-or-later
// A libhidapi with one SpaceMouse that is not there: under it (LD_LIBRARY_PATH) the program's own adapter runs as it
// is. What happens is read from the file that SANDREEL_FAKE_HID names, a line each:
//   device <vendor> <product> <usage page> <usage> <product name>   hexadecimal numbers; one more device, "/fake/<n>"
//   forbidden                                                      that device cannot be opened
//   report <bytes>        hexadecimal; read in turn, 2 ms apart, from the first device
//   gone                  reading fails from here on; the next open begins behind it
// Output reports are appended to the file that SANDREEL_FAKE_HID_SENT names.
#include <hidapi/hidapi.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

namespace {

struct Device
{
    unsigned short vendor = 0, product = 0, page = 0, usage = 0;
    std::wstring name;
    bool isForbidden = false;
};

std::vector<Device> devices;
std::vector<std::vector<unsigned char>> reports; ///< empty: gone
std::size_t nextReport = 0;
bool isRead = false;

void readFile()
{
    if (isRead)
        return;
    isRead = true;
    const char *const path = std::getenv("SANDREEL_FAKE_HID");
    std::ifstream file(path ? path : "");
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        std::string what;
        words >> what >> std::hex;
        if (what == "device") {
            Device device;
            std::string name;
            words >> device.vendor >> device.product >> device.page >> device.usage;
            std::getline(words >> std::ws, name);
            device.name.assign(name.begin(), name.end());
            devices.push_back(device);
        } else if (what == "forbidden") {
            devices.back().isForbidden = true;
        } else if (what == "report") {
            std::vector<unsigned char> bytes;
            for (unsigned byte = 0; words >> byte;)
                bytes.push_back(static_cast<unsigned char>(byte));
            reports.push_back(bytes);
        } else if (what == "gone") {
            reports.emplace_back();
        }
    }
}

} // namespace

struct hid_device_
{
    bool isGone = false;
};

extern "C" {

int hid_init()
{
    readFile();
    return 0;
}
int hid_exit()
{
    return 0;
}

hid_device_info *hid_enumerate(unsigned short, unsigned short)
{
    readFile();
    hid_device_info *list = nullptr;
    for (std::size_t i = devices.size(); i-- > 0;) {
        auto *const info = static_cast<hid_device_info *>(std::calloc(1, sizeof(hid_device_info)));
        info->path = strdup(("/fake/" + std::to_string(i)).c_str());
        info->vendor_id = devices[i].vendor;
        info->product_id = devices[i].product;
        info->usage_page = devices[i].page;
        info->usage = devices[i].usage;
        info->product_string = wcsdup(devices[i].name.c_str());
        info->next = list;
        list = info;
    }
    return list;
}

void hid_free_enumeration(hid_device_info *list)
{
    while (list) {
        hid_device_info *const next = list->next;
        std::free(list->path);
        std::free(list->product_string);
        std::free(list);
        list = next;
    }
}

hid_device *hid_open_path(const char *path)
{
    readFile();
    const std::size_t index = std::size_t(std::atoi(std::strrchr(path, '/') + 1));
    if (index >= devices.size() || devices[index].isForbidden)
        return nullptr;
    return new hid_device_;
}

void hid_close(hid_device *device)
{
    delete device;
}

int hid_read_timeout(hid_device *device, unsigned char *data, size_t length, int milliseconds)
{
    if (device->isGone)
        return -1;
    if (nextReport >= reports.size()) {
        std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
        return 0;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    const std::vector<unsigned char> &report = reports[nextReport++];
    device->isGone = report.empty();
    if (device->isGone)
        return -1;
    const size_t count = std::min(length, report.size());
    std::memcpy(data, report.data(), count);
    return int(count);
}

int hid_read(hid_device *device, unsigned char *data, size_t length)
{
    return hid_read_timeout(device, data, length, -1);
}
int hid_set_nonblocking(hid_device *, int)
{
    return 0;
}

int hid_write(hid_device *, const unsigned char *data, size_t length)
{
    if (const char *const path = std::getenv("SANDREEL_FAKE_HID_SENT")) {
        std::ofstream file(path, std::ios::app);
        for (size_t i = 0; i < length; ++i) {
            char text[4];
            std::snprintf(text, sizeof text, "%02x ", data[i]);
            file << text;
        }
        file << '\n';
    }
    return int(length);
}

int hid_send_feature_report(hid_device *, const unsigned char *, size_t)
{
    return -1;
}
int hid_get_feature_report(hid_device *, unsigned char *, size_t)
{
    return -1;
}
const wchar_t *hid_error(hid_device *)
{
    return L"the fake says no";
}
const char *hid_version_str()
{
    return "0.13.1";
}
}
