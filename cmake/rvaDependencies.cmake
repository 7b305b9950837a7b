# The targets of other projects that the libraries link to, and where they are from. The project's own configuration
# finds all of them, and the installed one, rvaConfig.cmake, those that the requested components link to. Each defines
# rva_find(TARGET PACKAGE [ARGUMENTS...]) and rva_find_module(NAME MODULE), for PkgConfig::NAME.

rva_find(Threads::Threads Threads)
rva_find(fmt::fmt fmt)
rva_find(Eigen3::Eigen Eigen3 3.4 NO_MODULE)
rva_find(Boost::headers Boost 1.74)
rva_find(opencv_core OpenCV 4.6 COMPONENTS core)
rva_find(opencv_imgproc OpenCV 4.6 COMPONENTS imgproc)
rva_find(opencv_dnn OpenCV 4.6 COMPONENTS dnn)
rva_find(nlohmann_json::nlohmann_json nlohmann_json)
rva_find(utf8cpp utf8cpp)
rva_find(embree embree 3)
rva_find(yaml-cpp yaml-cpp)
rva_find(assimp::assimp assimp)
rva_find(SQLiteCpp SQLiteCpp)
rva_find(OpenSSL::SSL OpenSSL)
rva_find(OpenSSL::Crypto OpenSSL)
rva_find(ICU::i18n ICU COMPONENTS i18n)
rva_find(ICU::uc ICU COMPONENTS uc)
rva_find_module(PCL pcl_common>=1.13)  # its CMake package asks for VTK and MPI
rva_find_module(LZ4 liblz4)
rva_find_module(ZSTD libzstd)
rva_find_module(SPNG spng)
rva_find_module(TURBOJPEG libturbojpeg)
rva_find_module(OPENEXR OpenEXR)
rva_find_module(TIFF libtiff-4)
rva_find_module(SODIUM libsodium)
