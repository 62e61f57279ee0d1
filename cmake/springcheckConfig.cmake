# find_package(springcheck) defines springcheck::meshing, springcheck::mss,
# springcheck::fem_reference, springcheck::tissue and one target for each of their folders,
# such as springcheck::meshing_generators. C++20.
include(CMakeFindDependencyMacro)
find_dependency(Boost)
find_dependency(Eigen3)
find_dependency(fmt)
find_dependency(OpenSSL COMPONENTS Crypto)
find_dependency(spdlog)
find_dependency(TBB)
find_dependency(deal.II 9.4.1)
include(${DEAL_II_TARGET_CONFIG})
include(${CMAKE_CURRENT_LIST_DIR}/springcheckTargets.cmake)
